#include "testbench/program/scheme_units.h"

namespace bump {

std::vector<NamedNetlist> units_of(const Design& design) {
  std::vector<NamedNetlist> units = {{"vertex", &design.vertex, false}};
  if (design.conversion) units.push_back({"conversion", &*design.conversion});
  units.push_back({"environment", &design.environment});
  if (design.light_maps)
    units.push_back({"light_map_address", &design.light_maps->address, true, static_cast<int>(design.light_maps->maps.size())});
  units.push_back({"illumination", &design.illumination});
  if (design.light_maps) units.push_back({"frame", &design.light_maps->fill, false});
  return units;
}

Inventory published_of(const NamedNetlist& unit) {
  Inventory inventory = count(*unit.netlist, Portion::published);
  inventory.maps += unit.light_maps;
  return inventory;
}

const Netlist& unit_of(const Design& design, const std::string& scheme, const std::string& unit) {
  std::vector<std::string> names;
  std::string list;
  for (const NamedNetlist& known : units_of(design)) {
    if (known.name == unit) return *known.netlist;
    names.push_back(known.name);
    list += (list.empty() ? "" : ", ") + known.name;
  }
  const std::string near = nearest_word(unit, names);
  if (unit == "conversion")
    throw Error({"scheme " + scheme + " has no conversion unit in this configuration", {}, "its angles come from the vertices", "bumpsim describe " + scheme});
  throw Error({"scheme " + scheme + " has no unit '" + unit + "'", {}, "its units are: " + list, near.empty() ? "" : near});
}

}  // namespace bump
