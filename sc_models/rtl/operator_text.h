#pragma once
// The operators that are written where they are used, as combinational Verilog: the exact result in `<result>_exact` where there is one,
// then the rounding rule. Dividers, roots, adder-subtractors and tables are modules (divider_module.h and its neighbours).

#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "rtl/word_text.h"

namespace bump {

/// Declarations and assignments that give the wire `result`, of the node's format, from the operands in the netlist's order: lines with an
/// indentation of two. All operators but input, constant, table, column, div, sqrt and add_sub.
std::string operator_text(const Node& node, const std::string& result, const std::vector<WordText>& operands);

/// A product: the exact word is `exact`, of the factors' formats.
WordText product_word(const std::string& exact, const WordText& a, const WordText& b);

/// Its value: the language widens the factors by their signs, and synthesis tools see their true widths.
std::string product_value(const WordText& a, const WordText& b);

/// "wire [w-1:0] name = value;" in a line.
std::string wire_text(const std::string& name, int width, const std::string& value);

}  // namespace bump
