#include "system/accounting.h"

#include <algorithm>

namespace bump {

UnitCost unit_cost(const std::string& name, const Netlist& netlist, const Schedule* schedule, std::int64_t executions) {
  UnitCost cost;
  cost.name = name;
  cost.published = count(netlist, Portion::published);
  cost.addition = count(netlist, Portion::addition);
  cost.executions = executions;
  cost.multipliers_built = cost.published.multipliers + cost.addition.multipliers;
  if (schedule != nullptr) {
    cost.latency = schedule->latency;
    cost.initiation_interval = schedule->initiation_interval;
    cost.multipliers_built = schedule->multipliers_built;
  }
  return cost;
}

std::vector<TableUse> table_uses(const std::string& unit, const Netlist& netlist, std::int64_t executions, int materials) {
  std::vector<TableUse> uses;
  for (const Node& node : netlist.nodes()) {
    if (node.op != Op::table) continue;
    const Table& table = *netlist.tables()[static_cast<std::size_t>(node.table)];
    auto use = std::find_if(uses.begin(), uses.end(), [&](const TableUse& u) { return u.name == table.name && u.addition == node.addition; });
    if (use == uses.end()) {
      uses.push_back({unit, table.name, table.formula, table.entries(), table.bits(), 0, 0, node.addition});
      use = uses.end() - 1;
    }
    use->copies += table.per_material ? materials : 1;
    use->reads += executions;
  }
  return uses;
}

}  // namespace bump
