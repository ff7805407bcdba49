#include "system/accounting.h"

#include <algorithm>
#include <set>

#include "units/light_map_fill.h"

namespace bump {

UnitCost unit_cost(const std::string& name, const Netlist& netlist, const Schedule* schedule, std::int64_t executions) {
  UnitCost cost;
  cost.name = name;
  cost.published = count(netlist, Portion::published);
  cost.addition = count(netlist, Portion::addition);
  cost.executions = executions;
  if (schedule != nullptr) cost.pipeline = {schedule->unit_latency(), schedule->initiation_interval, schedule->multipliers_built};
  return cost;
}

UnitCost frame_cost(const LightMaps& maps, const std::vector<Light>& lights, std::int64_t executions) {
  UnitCost cost = unit_cost("frame", maps.fill, nullptr, executions);
  cost.per_light = count(maps.fill);
  cost.lights = std::max(1, static_cast<int>(lights.size()));
  const bool scaled = scales_lights(lights);
  cost.published += count(light_sum_netlist(maps, scaled, false));
  cost.per_light += count(light_sum_netlist(maps, scaled, true));
  return cost;
}

void keep_tables_per_material(UnitCost& cost, const Netlist& netlist, int materials) {
  std::set<std::string> seen;
  for (const Node& node : netlist.nodes()) {
    if (node.op != Op::table) continue;
    const Table& table = *netlist.tables()[static_cast<std::size_t>(node.table)];
    if (!table.per_material || node.second_port) continue;
    Inventory& portion = node.addition ? cost.addition : cost.published;
    portion.table_bits += table.bits() * (materials - 1);
    if (seen.insert(table.name).second) portion.distinct_table_bits += table.bits() * (materials - 1);
  }
}

std::vector<TableUse> table_uses(const std::string& unit, const Netlist& netlist, std::int64_t executions, int materials) {
  std::vector<TableUse> uses;
  for (const Node& node : netlist.nodes()) {
    if (node.op != Op::table) continue;
    const Table& table = *netlist.tables()[static_cast<std::size_t>(node.table)];
    auto use =
        std::find_if(uses.begin(), uses.end(), [&](const TableUse& u) { return u.name == table.name && u.addition == node.addition; });
    if (use == uses.end()) {
      uses.push_back({unit, table.name, table.formula, table.entries(), table.bits(), 0, 0, node.addition});
      use = uses.end() - 1;
    }
    if (!node.second_port) use->copies += table.per_material ? materials : 1;
    use->reads += executions;
  }
  return uses;
}

std::vector<LightMapUse> light_map_uses(const LightMaps& maps, const LightMapFetch& fetch) {
  std::vector<LightMapUse> uses;
  for (std::size_t i = 0; i < maps.maps.size(); ++i) {
    LightMapUse use;
    use.name = maps.maps[i].name;
    use.entries = std::int64_t{1} << maps.address_bits;
    use.words_written = fetch.words_written();
    use.bits = use.words_written * maps.maps[i].word.width;
    use.bytes_written = use.words_written * fetch.word_bytes(static_cast<int>(i));
    use.counters = fetch.counters()[i];
    uses.push_back(std::move(use));
  }
  return uses;
}

}  // namespace bump
