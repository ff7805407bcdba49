#pragma once
// What the vertex processor needs to know of a vertex program: which of its nodes depend on the light or on the eye, so that the rest runs
// once for all lights, and how many operations a chosen part costs. A vertex program is a netlist with `real` edges: a program on ALUs,
// not a pipeline, so it is counted and never scheduled.

#include <string>
#include <vector>

#include "datapath/inventory.h"
#include "datapath/netlist.h"

namespace bump {

/// Per node: whether it depends on any input whose name starts with one of the prefixes, e.g. "L.".
std::vector<bool> depends_on(const Netlist& netlist, const std::vector<std::string>& input_prefixes);

/// Counts the nodes with which[node] set; `which` has one entry per node. A table counts with its `table` node, tables of one name are
/// distinct once.
Inventory count_nodes(const Netlist& netlist, const std::vector<bool>& which);

}  // namespace bump
