#!/usr/bin/env bash
# Writes reports/performance.md: engines, evaluators, re-timing, whole runs and start-up, side by side in one run. About ten minutes on an idle machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" python3
build_in build all
build_in build benches
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bench=build/testbench/bench
$bench/bench_engines 2>/dev/null >"$work/engines.md"
$bench/bench_engines --size 2048 --scenes world_sphere,bunny --schemes lee2007,peercy1997 --depths 4 2>/dev/null >"$work/engines-large.md"
$bench/bench_stages 2>/dev/null >"$work/stages.md"
$bench/bench_stages --rounds 3 --scenes world_sphere --sizes 256,512,1024,2048,4096,8192 2>/dev/null >"$work/sizes.md"
$bench/bench_datapath >"$work/datapath.txt"
for scene in world_sphere bunny; do
  build/bumpsim run $scene --no-quality --record "$work/$scene.trace" --addresses --out "$work/$scene" >/dev/null
done
$bench/bench_dates "$work/world_sphere.trace" "$work/bunny.trace" >"$work/dates.md"
$bench/bench_retime "$work/world_sphere.trace" "$work/bunny.trace" >"$work/retime.json"
python3 scripts/performance_report.py "$work" >"$work/performance.md"
mv "$work/performance.md" reports/performance.md
echo "reports/performance.md is up to date"
