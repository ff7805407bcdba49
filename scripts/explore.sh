#!/usr/bin/env bash
# Writes reports/pareto.md and its plots: all schemes at equal quality, each with the structure and the widths that `bumpsim fit` finds on the
# paper's scenes, held against scenes that were not used to choose them, priced, and under a multiplier limit. About forty minutes on two idle
# cores. With EXPLORE_WORK=DIR it goes on where it was stopped: fits that are there are not made again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" python3
build_in build bumpsim
work=${EXPLORE_WORK:-$(mktemp -d)}
mkdir -p "$work" reports/pictures
prices=(--prices osu018_model --prices horowitz45)

schemes=$(build/bumpsim list | awk '/^schemes/ {on = 1; next} /^scenes/ {on = 0} on {print $1}')
for target in 30 40 48; do
  for scheme in $schemes; do
    out="$work/fit-$target-$scheme.json"
    [ -e "$out" ] || build/bumpsim fit wood_plane brick_cube world_sphere --scheme "$scheme" --psnr $target --cost area "${prices[@]}" \
      --json --out "$out" || true  # a scheme that fails is a row
  done
done
python3 scripts/explore_report.py specification "$work"
build/bumpsim sweep "$work/others.toml" --out "$work/others" --force >/dev/null
build/bumpsim sweep "$work/limited.toml" --out "$work/limited" --force >/dev/null
python3 scripts/explore_report.py table "$work"
plot() {
  build/bumpsim pareto "$work/fits.csv" --x "$1" --y psnr_worst_db --title "$2" --out "reports/pictures/pareto-$3.svg" --force "${@:4}" >"$work/pareto-$3.txt"
}
plot area_nand2 "Area against quality" area --log x
plot energy_pj_per_fragment "Energy against quality" energy --log x
plot table_kilobytes "Tables against quality" tables --log x
plot multiplier_cells "Multiplier cells against quality" multipliers
python3 scripts/explore_report.py report "$work" >"$work/pareto.md"
mv "$work/pareto.md" reports/pareto.md
echo "reports/pareto.md is up to date"
