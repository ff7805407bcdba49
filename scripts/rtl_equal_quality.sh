#!/usr/bin/env bash
# Schemes at equal picture quality in gates: designs that `bumpsim fit` found, synthesised with their tables into 0.18 um cells, with the
# energy of the mapped netlists. Figures go to build/rtl/equal_quality.json; scripts/rtl_report.py puts them into reports/rtl.md.
#   scripts/rtl_equal_quality.sh                       # Lee 2007, four forms of Peercy 1997, lns and n2l; makes their fits itself
#   scripts/rtl_equal_quality.sh --fits build/explore  # all schemes, from EXPLORE_WORK=build/explore scripts/explore.sh
#   scripts/rtl_equal_quality.sh --fits build/explore --schemes lee2007,peercy1997 --targets 40 --no-energy
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
case " $* " in
  *" --program "* | *" --help "* | *" -h "*) ;;
  *)
    install_packages "${build_packages[@]}" python3 iverilog yosys opensta qflow-tech-osu018
    build_in build bumpsim
    ;;
esac
exec python3 scripts/rtl/equal_quality.py "$@"
