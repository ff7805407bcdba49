#!/usr/bin/env bash
# Builds the program with g++ and with clang++ and compares the bytes of their results on every shipped scene and scheme.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" clang
build_in build bumpsim
build_in build-clang bumpsim -DCMAKE_CXX_COMPILER=clang++
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
schemes=$(build/bumpsim list schemes | awk 'NR > 1 { print $1 }')
for scene in scenes/*.toml; do
  name=$(basename "$scene" .toml)
  for scheme in $schemes; do
    for build in build build-clang; do
      rm -rf "${work:?}/$build"
      "$build/bumpsim" run "$scene" --scheme "$scheme" --out "$work/$build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    done
    # `host` is the last member of result.json, and the only one that may differ.
    for build in build build-clang; do sed -i '/^  "host": {/,$d' "$work/$build/result.json"; done
    if diff -rq "$work/build" "$work/build-clang" >&2; then
      echo "same bytes: $name $scheme"
      passed=$((passed + 1))
    else
      echo "DIFFERENT: $name $scheme"
      failed=$((failed + 1))
    fi
  done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
