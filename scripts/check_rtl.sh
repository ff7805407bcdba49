#!/usr/bin/env bash
# Checks the Verilog of every scheme with other people's tools: Verilator (lint, bit-exact), Icarus (test benches), Yosys (operators,
# registers, DSP blocks, area in 0.18 um cells), OpenSTA (clock), nextpnr (place and route), and SystemC with Verilator's models (cycles).
# Twelve minutes on two idle cores, an hour with --full. One line a check,
# "ok|FAILED|skipped <check> <scheme> <unit> <detail>"; the last line is "N passed, M failed", exit code 1 if any failed.
#   scripts/check_rtl.sh                       every scheme; figures go to build/rtl/results.json; samples as scripts/rtl/settings.toml says
#   scripts/check_rtl.sh --full                no samples
#   scripts/check_rtl.sh --quick               two schemes, 100000 vectors, counts
#   scripts/check_rtl.sh --schemes lns,yp6 --checks area,clock --widths 8,12
#   scripts/check_rtl.sh --no-install --program build/bumpsim   neither installs nor builds; what lacks its tool is skipped
# scripts/rtl_report.py writes reports/rtl.md from the figures.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
cd "$here/.."
. scripts/packages.sh
case " $* " in
  *" --no-install "* | *" --help "* | *" -h "*) ;;
  *)
    install_packages "${build_packages[@]}" python3 make verilator iverilog yosys opensta nextpnr-ice40 fpga-icestorm qflow-tech-osu018
    build_in build bumpsim
    ;;
esac
exec python3 scripts/rtl/check.py "$@"
