#pragma once
// What a recorded operator and a table must satisfy for their words to be computed exactly in 64 bits. Only the author of a scheme can
// break these rules, so a violation is a fault of the program: Error(internal) that names the netlist, the node and the rule.

#include <string>
#include <vector>

#include "datapath/format.h"
#include "datapath/netlist.h"
#include "datapath/table.h"

namespace bump {

/// Throws Error(internal) "what" unless the condition holds.
void require(bool condition, const std::string& what);

/// Width 1..62 and |fraction| <= 128, or `real`. `whose` opens the message.
void check_format(const Format& format, const std::string& whose);

/// Folding rules, column formats and sizes of a table.
void check_table(const Table& table);

/// Operand formats of a node. `whose` opens the message.
void check_operator(const Node& node, const std::vector<Format>& operands, const std::string& whose);

}  // namespace bump
