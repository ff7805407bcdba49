#pragma once
// The adder-subtractor of a netlist as Verilog: one adder whose second summand, and carry in, a flag inverts; the fractions aligned in
// front of it and the result cut to its format behind it by the rounding rule of format.h. Combinational: the datapath registers the
// result.

#include "rtl/verilog.h"

namespace bump {

/// Ports subtract, a, b, q: q = a - b if subtract is set, else a + b. The module is called after its formats, e.g.
/// "addsub_s12_10_u8_8_to_s13_10". The aligned operands have at most 61 bits.
VerilogModule adder_subtractor_module(const Format& a, const Format& b, const Format& sum);

}  // namespace bump
