#include "schemes/yp4/units.h"

#include <utility>

#include "schemes/common/sums_projection.h"

namespace bump::yp4 {

namespace {

/// The bracket has two halvings.
Format bracket(const YPoleParameters& p) {
  return sfixed(p.word_bits + 4, p.word_bits + 2);
}

}  // namespace

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  SineReads r(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", r), light = input_polar(n, "L", r), half = input_polar(n, "H", r);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Wire Psi = r.plus("N.Psi", texel.psi, normal.theta, "YP6 step 3");
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    Wire flat, K;
    {
      const Netlist::Scope scope(n, name);
      const Wire d = r.minus("d", a.phi, normal.phi, "Lee Eq 6");
      Netlist::Label label(n, "YP4 step 2");
      const Wire u = r.minus("u", a.theta, Psi), v = r.plus("v", a.theta, Psi);
      const auto cosine = [&](const std::string& of, Wire angle) { return r.cosine("COS_" + of, angle); };
      const Wire cos_u = cosine("u", u), cos_v = cosine("v", v);
      label.next("YP4 step 3");
      const Wire cos_u_plus = cosine("u_plus_d", r.plus("u_plus_d", u, d)), cos_u_minus = cosine("u_minus_d", r.minus("u_minus_d", u, d));
      const Wire cos_v_plus = cosine("v_plus_d", r.plus("v_plus_d", v, d)), cos_v_minus = cosine("v_minus_d", r.minus("v_minus_d", v, d));
      const Wire along = r.half_sum("along", cos_u, cos_v, "YP4 step 2");
      const Wire across = r.sum("across", {cos_u_plus, cos_u_minus}, {cos_v_plus, cos_v_minus}, 2);
      flat = n.add("flat", along, across, bracket(p), "YP4 step 1");
      label.next("YP4 step 4");
      const Wire cos_Y = cosine("Y", r.minus("Y", a.theta, d, "Lee Eq 6")), cos_X = cosine("X", r.plus("X", a.theta, d, "Lee Eq 6"));
      K = r.half_difference("K", cos_Y, cos_X, "Lee Eq 9");
    }
    n.output(name + "_turned.flat", flat);
    n.output(name + "_turned.K", K);
  }
  n.output("N_turned.cos_b", r.cosine("N.COS_B", texel.latitude, "YP4 step 1"));
  n.output("N_turned.sin_b", r.sine("N.SIN_B", texel.latitude, "YP4 step 1"));
  return n;
}

Netlist illumination_unit(const YPoleParameters& p, const Material& material) {
  Netlist n("illumination");
  const Wire cos_b = n.input("N_turned.cos_b", p.word()), sin_b = n.input("N_turned.sin_b", p.word());
  const auto dot = [&](const std::string& name, const std::string& of) {
    const Wire flat = n.input(of + "_turned.flat", bracket(p)), K = n.input(of + "_turned.K", p.half_word());
    const Netlist::Scope scope(n, name);
    const Wire along = n.mul("flat_cos", flat, cos_b, p.product(), "YP4 step 1"),
               across = n.mul("K_sin", K, sin_b, p.product(), "YP4 step 1");
    return n.add("dot", along, across, p.product(), "YP4 step 1");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::yp4
