#pragma once
// The netlists of a design by the names that users type.

#include <string>
#include <vector>

#include "datapath/inventory.h"
#include "schemes/scheme.h"

namespace bump {

struct NamedNetlist {
  std::string name;
  const Netlist* netlist;
  bool is_datapath = true;  ///< per-pixel hardware; not a program of the vertex processor or the host
  int light_maps = 0;       ///< maps that it addresses: they count as maps of the unit
};

/// "vertex", "conversion" (if the design has one), "environment", "light_map_address" (if it has light maps), "illumination", "frame" (what
/// fills the light maps). Valid as long as the design lives.
std::vector<NamedNetlist> units_of(const Design& design);
/// What the unit is built of, without additions, with the light maps that it addresses.
Inventory published_of(const NamedNetlist& unit);
/// Throws Error(input) naming the units that exist.
const Netlist& unit_of(const Design& design, const std::string& scheme, const std::string& unit);

}  // namespace bump
