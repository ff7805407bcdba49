#pragma once
// The square root of a netlist as Verilog: a restoring array of one row a root bit, of the words of arithmetic.h. A row brings in two bits
// of the radicand and is one subtractor, no wider than its remainder can be, and a multiplexer. Root bits above those of the format are
// found and dropped. Timing: rows are shared out over stages + 1 segments of logic with a register between two, the first segments full; a
// result a clock, nothing stalls. The root is not registered. Leaves out: the divider (divider_module.h). Source: see arithmetic.h.

#include "rtl/verilog.h"

namespace bump {

/// Ports clk (unless stages is 0), a, q. a is unsigned; stages >= 0. The module is called after its formats, e.g. "sqrt_u16_14_to_u9_8",
/// with "_n<stages>" behind unless the segments are as many as the root's bits.
VerilogModule square_root_module(const Format& a, const Format& root, int stages);

}  // namespace bump
