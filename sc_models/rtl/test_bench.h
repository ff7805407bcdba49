#pragma once
// The self-checking test bench of an emitted unit, in Verilog-2001 for Icarus Verilog and for `verilator --binary`. It reads the vectors
// (one word a line, {in_0, .., out_0, ..}, the first port in the highest bits), sends them through the unit twice, first as fast as the
// unit takes them, then with random pauses on both sides, then some again between resets of one cycle, and compares every word that the unit shows and, in every cycle, in_ready and
// out_valid with the recurrences of unit_module.h. It prints one line at the end and stops with an error if anything differed.

#include <string>

#include "rtl/unit_module.h"

namespace bump {

/// "test/<unit>_tb.v": module <scheme>_<unit>_tb with parameters VECTORS (all of the file), CAPACITY and SEED.
std::string test_bench(const RtlUnit& unit, int vectors);

}  // namespace bump
