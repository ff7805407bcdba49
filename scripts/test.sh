#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, runs the tests and prints how many passed.
#   scripts/test.sh            all tests
#   scripts/test.sh -R timing  arguments are passed on to ctest
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}"
build_in build all
log=build/tests.log
status=0
ctest --test-dir build -j "$(nproc)" --output-on-failure --no-tests=error "$@" >"$log" 2>&1 || status=$?
total=$(grep -c -E '^ *[0-9]+/[0-9]+ Test +#' "$log" || true)
failed=$(grep -E '^ *[0-9]+/[0-9]+ Test +#' "$log" | grep -c -v -E ' Passed +[0-9.]+ sec' || true)
if [ "$status" -ne 0 ]; then
  cat "$log"
  if [ "$failed" -eq 0 ]; then failed=1; fi
fi
echo "$((total - failed)) passed, $failed failed"
exit "$status"
