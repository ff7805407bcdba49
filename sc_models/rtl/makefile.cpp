#include "rtl/makefile.h"

#include <fmt/core.h>

namespace bump {

namespace {

// Recipes begin with a tab.
const char* const rules = R"make(
# How many of the vectors (empty: all), where random pauses begin, and the tokens in flight (empty: the unit's own).
VECTORS ?=
SEED ?= 1
CAPACITY ?=
# How the harness and Verilator's model are compiled.
CXXFLAGS ?= -O2

help:
	@echo "make lint       Verilator finds nothing to complain about in the modules"
	@echo "make test       the test benches, run by Icarus Verilog"
	@echo "make verilate   the same checks in C++ around Verilator's models, some hundred times faster"
	@echo "make counts     Yosys finds exactly the multipliers, adders, dividers, square roots and tables that bumpsim counts"
	@echo "make check      all of these"
	@echo "make clean      removes build/"
	@echo "Units: $(UNITS). One alone: make test-UNIT. Variables: VECTORS=1000 SEED=2 CAPACITY=3."

check: lint test verilate counts

# What is given must make sense, and the ROM images must be the ones that were written.
ready:
	@case "$(VECTORS)" in "" | [2-9] | [1-9][0-9]*) ;; *) echo "make: VECTORS=$(VECTORS) is no number from 2 upwards" >&2; exit 1;; esac
	@case "$(CAPACITY)" in "" | [1-9] | [1-9][0-9]*) ;; *) echo "make: CAPACITY=$(CAPACITY) is no number from 1 upwards" >&2; exit 1;; esac
	@case "$(VECTORS)$(CAPACITY)$(SEED)" in *[!0-9]*) echo "make: VECTORS, CAPACITY and SEED are whole numbers" >&2; exit 1;; esac
	@[ ! -s test/roms.sha256 ] || ! command -v sha256sum >/dev/null || sha256sum --quiet --check test/roms.sha256

lint: $(UNITS:%=lint-%)
test: $(UNITS:%=test-%)
verilate: $(UNITS:%=verilate-%)
counts: $(UNITS:%=counts-%)
clean:
	rm -rf build

need = @command -v $(1) >/dev/null || { echo "make: $(1) is not installed; on Debian: apt install $(2)" >&2; exit 1; }

$(UNITS:%=lint-%): lint-%:
	$(call need,verilator,verilator)
	verilator --lint-only -Wall -y rtl --top-module $(SCHEME)_$* rtl/$(SCHEME)_$*.v
	@echo "$*: lint found nothing"

$(UNITS:%=test-%): test-%: ready
	$(call need,iverilog,iverilog)
	@mkdir -p build
	iverilog -g2001 -y rtl -s $(SCHEME)_$*_tb $(VECTORS:%=-P$(SCHEME)_$*_tb.VECTORS=%) $(CAPACITY:%=-P$(SCHEME)_$*_tb.CAPACITY=%) \
	  -P$(SCHEME)_$*_tb.SEED=$(SEED) -o build/$*_tb.vvp test/$*_tb.v
	vvp -N build/$*_tb.vvp

$(UNITS:%=verilate-%): verilate-%: ready
	$(call need,verilator,verilator)
	@mkdir -p build
	verilator --cc --exe --build -O3 --x-assign unique --x-initial unique --prefix Vunit --top-module $(SCHEME)_$* \
	  -Mdir build/$*$(CAPACITY:%=-%) $(CAPACITY:%=-GCAPACITY=%) \
	  -CFLAGS "$(CXXFLAGS) -std=c++17 -I../../test -DUNIT_PORTS=$*_ports.h $(CAPACITY:%=-DUNIT_CAPACITY=%)" \
	  -y rtl rtl/$(SCHEME)_$*.v ../../test/harness.cpp -o check >build/$*_verilator.log 2>&1 || { cat build/$*_verilator.log >&2; exit 1; }
	build/$*$(CAPACITY:%=-%)/check test/$*.hex '$(VECTORS)' '$(SEED)'

$(UNITS:%=counts-%): counts-%:
	$(call need,yosys,yosys)
	@mkdir -p build
	yosys -q -s test/$*.ys

.PHONY: help check ready lint test verilate counts clean $(foreach target,lint test verilate counts,$(UNITS:%=$(target)-%))
)make";

}  // namespace

std::string makefile_text(const std::string& scheme, const std::vector<RtlUnit>& units) {
  std::string names;
  for (const RtlUnit& unit : units) names += " " + unit.unit;
  return fmt::format(
             "# Checks of the units of {0}, by other people's tools. All of them run in this folder; `make` says what there is.\n\n"
             "SCHEME = {0}\nUNITS ={1}\n",
             verilog_identifier(scheme), names) +
         rules;
}

std::string yosys_script(const RtlUnit& unit, const ExpectedCells& cells) {
  std::string text = fmt::format(
      "# The operators of {0}, as Yosys finds them before it maps anything: operators without a reader are gone\n"
      "# (opt_clean), those of constants are not folded (-noopt).\n"
      "read_verilog rtl/*.v\nhierarchy -check -top {1}\nproc -noopt\nopt_clean\nmemory -nomap\n"
      "tee -q -o build/{2}_stat.txt stat\n",
      cells.module, unit.module.name, unit.unit);
  std::string summary;
  for (const ExpectedCells::Kind& kind : cells.kinds) {
    text += fmt::format("# {}\nselect -assert-count {}", kind.name, kind.count);
    for (const std::string& pattern : kind.patterns) text += fmt::format(" {}/t:{}", cells.module, pattern);
    text += "\n";
    summary += fmt::format("{} {} {}", summary.empty() ? "" : ",", kind.count, kind.name);
  }
  return text + fmt::format("log -stdout {}:{}, as counted\n", unit.unit, summary);
}

}  // namespace bump
