#pragma once
// A netlist as a list of components with sizes: what is built, and what one execution does. Widths are those of the operands as recorded.
// Shifts, joins, flags, half turns and single gates are wiring and have no component. A table of several outputs is one item with the
// stored bits of all columns; a column that is read from the first one's words at the complemented address is a second port, and so is a
// second index: a read of words that are stored once. A folded index and every column whose sign folding supplies need a conditional
// negation each. Multipliers that are shared in time are as wide as the widest products they take, with selects in front. Words of edges
// without a format (vertex programs, interpolators) are floating point, or fixed-point words of a width that the caller states. No time of
// its own.

#include <array>
#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"
#include "testbench/experiments/price_table.h"

namespace bump {

struct PriceItem {
  Component component = Component::adder;
  PriceSizes size{};
  double count = 0;
  bool addition = false;  ///< not part of the published design
  std::string node;       ///< one that needs it, for messages
};

struct ItemOptions {
  int real_bits = 0;  ///< edges without format: 0 floating point of 32 bits, else fixed-point words of so many bits
  int materials = 1;  ///< copies of tables whose contents follow the material
  /// Constants, by node, that a register holds because the material sets them: an operand like any other. Empty: none.
  std::vector<bool> settable;
};

/// Operations of one execution, and table reads.
std::vector<PriceItem> executed_items(const Netlist& netlist, const ItemOptions& options = {});
/// What is built: the same with every multiplier that the schedule leaves, each as wide as its widest products. Null: nothing is shared.
std::vector<PriceItem> built_items(const Netlist& netlist, const Schedule* schedule, const ItemOptions& options = {});

/// Constants whose values differ between two recordings of one structure.
std::vector<bool> differing_constants(const Netlist& netlist, const Netlist& other);

/// Equal components of equal sizes, additions apart, as one item each; in order of component, then of first appearance.
std::vector<PriceItem> merged(const std::vector<PriceItem>& items);

}  // namespace bump
