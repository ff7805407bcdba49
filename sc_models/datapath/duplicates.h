#pragma once
// Finds operators that are recorded twice. A synthesis tool merges equal operators, so a netlist with duplicates counts hardware that
// nobody would build; tests of schemes use this to keep the counts honest.

#include <utility>
#include <vector>

#include "datapath/netlist.h"

namespace bump {

/// Pairs (first, duplicate) of node indices, in order of the duplicate: same operator, operands, format and parameters. Operands of `add`
/// and `mul` may be swapped, and operands that are duplicates themselves count as one. Inputs, constants and columns are not operators and
/// not listed.
std::vector<std::pair<int, int>> equal_nodes(const Netlist& netlist);

}  // namespace bump
