#include "schemes/yp6g/units.h"

#include <utility>

#include "schemes/common/polar_map.h"
#include "schemes/common/sums_projection.h"

namespace bump::yp6g {

namespace {

/// a, s, c of N' = (phi, theta): 17 adders, 8 tables of 14 columns.
VectorWires turned_normal(Netlist& n, Wire phi, Wire theta, Wire normal_theta, const NormalFormats& formats, SineReads& r) {
  const Netlist::Scope scope(n, "N");
  const Netlist::Label label(n, "YP6G");
  const Wire u = r.plus("u", theta, normal_theta), v = r.minus("v", theta, normal_theta);
  const auto both = [&](const std::string& of, Wire angle) { return r.both("SC_" + of, angle); };
  const SineCosine at_u = both("u", u), at_v = both("v", v);
  const SineCosine u_plus = both("u_plus_ph", r.plus("u_plus_ph", u, phi)), u_less = both("u_less_ph", r.minus("u_less_ph", u, phi));
  const SineCosine v_plus = both("v_plus_ph", r.plus("v_plus_ph", v, phi)), v_less = both("v_less_ph", r.minus("v_less_ph", v, phi));
  const char *const step_a = "YP6G step 1", *const step_s = "YP6G step 2", *const step_c = "YP6G step 3";
  const Wire sum = r.cosine("COS_SUM", r.plus("theta_plus_ph", theta, phi, step_s), step_s);
  const Wire difference = r.cosine("COS_DIFFERENCE", r.minus("theta_less_ph", theta, phi, step_s), step_s);
  const Wire a_turned = r.sum("a_turned", {u_plus.sine, u_less.sine, v_plus.sine, v_less.sine}, {}, 2, step_a);
  const Wire c_turned = r.sum("c_turned", {u_plus.cosine, u_less.cosine}, {v_plus.cosine, v_less.cosine}, 2, step_c);
  VectorWires turned;
  turned.x = n.add("a", a_turned, r.half_difference("a_flat", at_u.sine, at_v.sine, step_a), formats.a, step_a);
  turned.y = r.half_difference("s", difference, sum, step_s);
  turned.z = n.add("c", c_turned, r.half_sum("c_flat", at_u.cosine, at_v.cosine, step_c), formats.c, step_c);
  return turned;
}

}  // namespace

NormalFormats normal_formats(const Yp6gParameters& p) {
  const Format quarter_sum = sfixed(p.sums.word_bits + 4, p.sums.word_bits + 2);
  return {quarter_sum, p.sums.half_word(), quarter_sum};
}

Netlist environment_unit(const Yp6gParameters& p) {
  Netlist n("environment");
  SineReads reads(n, p.sums.sums());
  const PolarDirection normal = input_polar(n, "N", reads), light = input_polar(n, "L", reads), half = input_polar(n, "H", reads);
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    const ProjectedWires of_a = projected(n, name, a, normal.phi, reads);
    n.output(name + "_turned.G", of_a.G);
    n.output(name + "_turned.K", of_a.K);
    n.output(name + "_turned.z", of_a.z);
  }
  const MapAngles texel = map_angles(n, p.polar);
  const Wire phi = turned_azimuth(n, texel.phi, p.polar);
  const VectorWires bumped = turned_normal(n, phi, texel.theta, normal.theta, normal_formats(p), reads);
  n.output("N_turned.a", bumped.x);
  n.output("N_turned.s", bumped.y);
  n.output("N_turned.c", bumped.z);
  return n;
}

}  // namespace bump::yp6g
