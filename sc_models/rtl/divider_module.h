#pragma once
// The divider of a netlist as Verilog: a restoring array of one row a quotient bit, of the words of arithmetic.h. The sign is taken off the
// dividend in front of the rows and put on the quotient behind them. What the dividend has above the quotient's bits is the first
// remainder; if it is not less than the divisor, as with divisor 0, the quotient is too large and its magnitude is all ones. A row is one
// subtractor, no wider than its remainder can be, and a multiplexer. Timing: rows are shared out over stages + 1 segments of logic with a
// register between two, the first segments full; a result a clock, nothing stalls. The quotient is not registered. Leaves out: the square
// root (square_root_module.h) and any other algorithm. Source: see arithmetic.h.

#include "rtl/verilog.h"

namespace bump {

/// Ports clk (unless stages is 0), a, b, q. b is unsigned; q is signed if a is; stages >= 0. The module is called after its formats, e.g.
/// "div_s15_13_by_u14_13_to_s13_11", with "_n<stages>" behind unless it is one row a segment.
VerilogModule divider_module(const Format& a, const Format& b, const Format& quotient, int stages);

}  // namespace bump
