#include "datapath/vertex_program.h"

#include <algorithm>
#include <set>

#include "datapath/invariant.h"

namespace bump {

namespace {

void count_table(const Table& table, bool second_port, std::set<std::string>& distinct, Inventory& inventory) {
  if (table.folding == Folding::floating) ++inventory.index_encoders;
  if (second_port) {
    ++inventory.second_ports;
    return;
  }
  (table.is_map() ? inventory.maps : inventory.tables) += 1;
  inventory.table_bits += table.bits();
  if (distinct.insert(table.name).second) inventory.distinct_table_bits += table.bits();
}

}  // namespace

std::vector<bool> depends_on(const Netlist& netlist, const std::vector<std::string>& input_prefixes) {
  std::vector<bool> depends;
  for (const Node& node : netlist.nodes()) {
    const auto starts_name = [&](const std::string& prefix) { return node.name.compare(0, prefix.size(), prefix) == 0; };
    const auto is_reached = [&](int operand) { return depends[static_cast<std::size_t>(operand)]; };
    depends.push_back(node.op == Op::input ? std::any_of(input_prefixes.begin(), input_prefixes.end(), starts_name)
                                           : std::any_of(node.operands.begin(), node.operands.end(), is_reached));
  }
  return depends;
}

Inventory count_nodes(const Netlist& netlist, const std::vector<bool>& which) {
  BUMP_ASSERT(which.size() == netlist.nodes().size());
  Inventory inventory;
  std::set<std::string> distinct;
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (!which[i]) continue;
    const Node& node = netlist.nodes()[i];
    switch (node.op) {
      case Op::input:
      case Op::constant:
      case Op::column:
        break;
      case Op::add:
      case Op::sub:
      case Op::add_sub:
        ++inventory.adders;
        break;
      case Op::mul:
        ++inventory.multipliers;
        break;
      case Op::div:
        ++inventory.dividers;
        break;
      case Op::sqrt:
        ++inventory.square_roots;
        break;
      case Op::table:
        count_table(*netlist.tables()[static_cast<std::size_t>(node.table)], node.second_port, distinct, inventory);
        break;
      case Op::join:
      case Op::shift:
        ++inventory.shifts;
        break;
      case Op::shift_by:
        ++inventory.shifters;
        break;
      case Op::negate:
      case Op::absolute:
      case Op::half_turn:
      case Op::is_negative:
      case Op::is_beyond_quarter:
      case Op::exclusive_or:
        ++inventory.sign_logic;
        break;
      case Op::clamp:
        ++inventory.clamps;
        break;
      case Op::select:
        ++inventory.selects;
        break;
    }
  }
  return inventory;
}

}  // namespace bump
