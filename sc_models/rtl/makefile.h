#pragma once
// The Makefile of an emitted folder and the Yosys scripts that it runs. Each target needs make, a shell and the one tool that it names, and
// fails with a message when something differs or the tool is missing.

#include <string>
#include <vector>

#include "rtl/expected_cells.h"
#include "rtl/unit_module.h"

namespace bump {

/// Targets lint, test, verilate, counts, clean; variables VECTORS, SEED and CAPACITY.
std::string makefile_text(const std::string& scheme, const std::vector<RtlUnit>& units);

/// "test/<unit>.ys": reads the modules, stops with an error unless the datapath has exactly the expected cells.
std::string yosys_script(const RtlUnit& unit, const ExpectedCells& cells);

}  // namespace bump
