#pragma once
// The netlists of a design by the names that users type.

#include <string>
#include <vector>

#include "schemes/scheme.h"

namespace bump {

struct NamedNetlist {
  std::string name;
  const Netlist* netlist;
};

/// "vertex", "conversion" (if the design has one), "environment", "illumination". Valid as long as the design lives.
std::vector<NamedNetlist> units_of(const Design& design);
/// Throws Error(input) naming the units that exist.
const Netlist& unit_of(const Design& design, const std::string& scheme, const std::string& unit);

}  // namespace bump
