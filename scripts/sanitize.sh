#!/usr/bin/env bash
# Builds with address and undefined-behaviour sanitizers and runs every test under them. Takes some minutes; arguments go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}"
build_in build-sanitize all -DBUMPSIM_SANITIZE=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo
# SystemC's coroutines switch stacks, which the leak checker cannot follow; OpenImageIO keeps plug-in state to the end.
export ASAN_OPTIONS=detect_leaks=0:detect_stack_use_after_return=0 UBSAN_OPTIONS=print_stacktrace=1
ctest --test-dir build-sanitize -j "$(nproc)" --output-on-failure --no-tests=error "$@"
