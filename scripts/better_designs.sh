#!/usr/bin/env bash
# Writes reports/better_designs.md: this project's smallest designs beside the smallest published ones at equal quality, fitted on the paper's
# scenes and held against others, what producing their inputs costs, and what was tried and is no better. About half an hour on two idle cores.
# BETTER_DESIGNS_WORK=DIR keeps the fits there and goes on with those that it holds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" python3
build_in build bumpsim
work=${BETTER_DESIGNS_WORK:-$(mktemp -d)}
mkdir -p "$work"
prices=(--prices osu018_model --prices horowitz45)

designs=("tl0" "lns" "peercy1997 transform=vertex normaliser=table" "tl2" "tl0 angles=pixel" "n2l" "yp6" "tl2 angles=pixel"
  "peercy1997 transform=vertex" "lnsg angles=pixel map_filter=vector" "lee2007")
for target in 40 48 30; do
  for design in "${designs[@]}"; do
    read -r scheme settings <<<"$design"
    out="$work/fit-$target-${design// /-}.json"
    [ -e "$out" ] || build/bumpsim fit wood_plane brick_cube world_sphere --scheme "$scheme" --psnr $target --cost area "${prices[@]}" \
      $([ -z "$settings" ] || printf -- "--set $scheme.%s " $settings) --json --out "$out" || true  # one that fails is a row
  done
done
python3 scripts/better_designs.py specification "$work"
build/bumpsim sweep "$work/held.toml" --out "$work/held" --force >/dev/null
build/bumpsim price all --real-bits 16 "${prices[@]}" --format json --out "$work/inputs-vertex.json" --force || true
pixel=$(for key in $(build/bumpsim describe --json | grep -o '"[a-z0-9_]*\.angles"' | tr -d '"' | sort -u); do echo "--set $key=pixel"; done)
build/bumpsim price all --real-bits 16 "${prices[@]}" $pixel --format json --out "$work/inputs-pixel.json" --force || true
build/bumpsim price peercy1997 --real-bits 16 "${prices[@]}" --set peercy1997.transform=vertex --format json --out "$work/inputs-variant.json" --force
python3 scripts/better_designs.py report "$work" >"$work/better_designs.md"
mv "$work/better_designs.md" reports/better_designs.md
echo "reports/better_designs.md is up to date"
