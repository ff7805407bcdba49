#!/usr/bin/env bash
# Builds with coverage counters, runs every test and prints the line coverage of sc_models and testbench. Fails below 85 %.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" lcov
build_in build-coverage all -DBUMPSIM_COVERAGE=ON
find build-coverage -name '*.gcda' -delete
ctest --test-dir build-coverage -j "$(nproc)" --output-on-failure --no-tests=error >build-coverage/tests.log || {
  tail -n 60 build-coverage/tests.log >&2
  exit 1
}
lcov --quiet --capture --directory build-coverage --base-directory . --no-external --output-file build-coverage/all.info 2>build-coverage/lcov.log
lcov --quiet --extract build-coverage/all.info "$PWD/sc_models/*" "$PWD/testbench/*" "$PWD/luts/*" --output-file build-coverage/ours.info 2>>build-coverage/lcov.log
lcov --quiet --remove build-coverage/ours.info '*/tests/*' '*/test_*.cpp' --output-file build-coverage/code.info 2>>build-coverage/lcov.log
lcov --list build-coverage/code.info
percent=$(lcov --summary build-coverage/code.info 2>&1 | sed -n 's/.*lines\.*: \([0-9.]*\)%.*/\1/p')
echo "line coverage: $percent % (at least 85 wanted)"
awk -v p="$percent" 'BEGIN { exit !(p >= 85) }'
