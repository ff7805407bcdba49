#include "schemes/common/sums_projection.h"

namespace bump {

PlaneWires projected_plane(Netlist& n, const std::string& name, const PolarDirection& a, Wire normal_phi, SineReads& reads) {
  const Netlist::Scope scope(n, name);
  PlaneWires p;
  p.d = reads.minus("d", a.phi, normal_phi, "Lee Eq 6");
  p.X = reads.plus("X", a.theta, p.d, "Lee Eq 6");
  p.Y = reads.minus("Y", a.theta, p.d, "Lee Eq 6");
  const SineCosine of_X = reads.both("SC_X", p.X, "Lee Eqs 7, 9"), of_Y = reads.both("SC_Y", p.Y, "Lee Eqs 7, 9");
  p.G = reads.half_sum("G", of_X.sine, of_Y.sine, "Lee Eq 7");
  p.K = reads.half_difference("K", of_Y.cosine, of_X.cosine, "Lee Eq 9");
  return p;
}

ProjectedWires projected(Netlist& n, const std::string& name, const PolarDirection& a, Wire normal_phi, SineReads& reads) {
  const PlaneWires plane = projected_plane(n, name, a, normal_phi, reads);
  const Netlist::Scope scope(n, name);
  return {plane.G, plane.K, reads.cosine("COS_THETA", a.theta, "YP6 step 1")};
}

PolarDirection input_polar(Netlist& n, const std::string& name, const SineReads& reads) {
  return input_direction(n, name, reads.widths().index);
}

TurnedNormalWires turned_normal(Netlist& n, Wire psi, Wire latitude, Wire normal_theta, SineReads& reads) {
  const Netlist::Scope scope(n, "N");
  const Netlist::Label label(n, "YP6 step 4");
  const Wire Psi = reads.plus("Psi", psi, normal_theta, "YP6 step 3");
  const SineCosine P = reads.both("SC_P", reads.plus("P", Psi, latitude));
  const SineCosine M = reads.both("SC_M", reads.minus("M", Psi, latitude));
  TurnedNormalWires t;
  t.a = reads.half_sum("a", P.sine, M.sine);
  t.s = reads.sine("SIN_B", latitude);
  t.c = reads.half_sum("c", P.cosine, M.cosine);
  return t;
}

}  // namespace bump
