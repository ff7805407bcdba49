#include "units/fragment_block.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

int PlaneMap::add(const std::string& name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<int>(found - names_.begin());
  names_.push_back(name);
  return static_cast<int>(names_.size()) - 1;
}

int PlaneMap::index(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    throw Error(
        ErrorKind::internal,
        {"no plane is called '" + name + "'", {}, "a netlist reads what nobody before it delivers", "see schemes/scheme.h for the names"});
  return static_cast<int>(found - names_.begin());
}

bool PlaneMap::contains(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::string plane_of_light(const std::string& name, int light) {
  return light == 0 ? name : name + "#" + std::to_string(light);
}

}  // namespace bump
