#include "schemes/yp6/units.h"

#include <utility>

#include "schemes/common/sums_projection.h"

namespace bump::yp6 {

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  SineReads reads(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", reads), light = input_polar(n, "L", reads), half = input_polar(n, "H", reads);
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const ProjectedWires of_a = projected(n, name, a, normal.phi, reads);
    n.output(name + "_turned.G", of_a.G);
    n.output(name + "_turned.K", of_a.K);
    n.output(name + "_turned.z", of_a.z);
  }
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const TurnedNormalWires bumped = turned_normal(n, texel.psi, texel.latitude, normal.theta, reads);
  n.output("N_turned.a", bumped.a);
  n.output("N_turned.s", bumped.s);
  n.output("N_turned.c", bumped.c);
  return n;
}

}  // namespace bump::yp6
