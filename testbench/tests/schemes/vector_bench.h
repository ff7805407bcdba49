#pragma once
// For tests of schemes with Cartesian vectors: vectors in and out of planes, and the operators of a netlist as one row of Table 1.

#include <array>
#include <string>

#include "datapath/inventory.h"
#include "testbench/tests/schemes/scheme_bench.h"

namespace bump::bench {

inline void set_vector(Planes& planes, const std::string& name, std::size_t lane, const glm::dvec3& v) {
  planes[name + ".x"][lane] = v.x;
  planes[name + ".y"][lane] = v.y;
  planes[name + ".z"][lane] = v.z;
}

inline glm::dvec3 vector_of(const Planes& planes, const std::string& name, std::size_t lane) {
  return {planes.at(name + ".x")[lane], planes.at(name + ".y")[lane], planes.at(name + ".z")[lane]};
}

/// Multipliers, adders, dividers, square roots, tables, maps that the paper has.
using Operators = std::array<int, 6>;
inline Operators operators(const Netlist& netlist, Portion portion = Portion::published) {
  const Inventory c = count(netlist, portion);
  return {c.multipliers, c.adders, c.dividers, c.square_roots, c.tables, c.maps};
}

}  // namespace bump::bench
