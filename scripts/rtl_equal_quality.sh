#!/usr/bin/env bash
# Schemes at equal picture quality in gates: the designs that scripts/explore.sh found, and Lee 2007 and four forms of the conventional
# method in the structures of the papers, synthesised with their tables into 0.18 um cells, with the energy of the mapped netlists. About
# forty minutes on two idle cores.
#   EXPLORE_WORK=build/explore scripts/explore.sh                               # the fits, and the report without gates
#   scripts/rtl_equal_quality.sh --fits build/explore                           # writes build/explore/equal_quality.json
#   scripts/explore_report.py report build/explore >reports/pareto.md           # the report with gates
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
