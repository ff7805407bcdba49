#include "schemes/yp2/units.h"

#include <utility>

#include "schemes/common/sums_projection.h"

namespace bump::yp2 {

namespace {

Format quarter_sum(const YPoleParameters& p) {
  return sfixed(p.word_bits + 4, p.word_bits + 2);
}

}  // namespace

Netlist environment_unit(const YPoleParameters& p) {
  Netlist n("environment");
  SineReads r(n, p.sums());
  const PolarDirection normal = input_polar(n, "N", r), light = input_polar(n, "L", r), half = input_polar(n, "H", r);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Wire b = texel.latitude, Psi = r.plus("N.Psi", texel.psi, normal.theta, "YP6 step 3");
  const Wire P = r.plus("N.P", Psi, b, "YP6 step 4"), M = r.minus("N.M", Psi, b, "YP6 step 4");
  for (const auto& [name, a] : {std::pair<std::string, PolarDirection>{"L", light}, {"H", half}}) {
    Wire G, rest;
    {
      const Netlist::Scope scope(n, name);
      const Wire theta = a.theta, d = r.minus("d", a.phi, normal.phi, "Lee Eq 6");
      const Wire X = r.plus("X", theta, d, "Lee Eq 6"), Y = r.minus("Y", theta, d, "Lee Eq 6");
      const Wire sin_X = r.sine("SIN_X", X, "Lee Eq 7"), sin_Y = r.sine("SIN_Y", Y, "Lee Eq 7");
      G = r.half_sum("G", sin_X, sin_Y, "Lee Eq 7");
      const auto cosine = [&](const std::string& of, Wire angle) { return r.cosine("COS_" + of, angle); };
      const auto sine = [&](const std::string& of, Wire angle) { return r.sine("SIN_" + of, angle); };
      Netlist::Label label(n, "YP2 step 1");
      const Wire theta_P = cosine("theta_plus_P", r.plus("theta_plus_P", theta, P)),
                 theta_P_less = cosine("theta_less_P", r.minus("theta_less_P", theta, P));
      const Wire theta_M = cosine("theta_plus_M", r.plus("theta_plus_M", theta, M)),
                 theta_M_less = cosine("theta_less_M", r.minus("theta_less_M", theta, M));
      label.next("YP2 step 2");
      const Wire b_Y = sine("b_plus_Y", r.plus("b_plus_Y", b, Y)), b_Y_less = sine("b_less_Y", r.minus("b_less_Y", b, Y));
      const Wire b_X = sine("b_plus_X", r.plus("b_plus_X", b, X)), b_X_less = sine("b_less_X", r.minus("b_less_X", b, X));
      rest = r.sum("rest", {theta_P, theta_P_less, theta_M, theta_M_less, b_Y, b_Y_less}, {b_X, b_X_less}, 2, "YP2");
    }
    n.output(name + "_turned.G", G);
    n.output(name + "_turned.rest", rest);
  }
  const Netlist::Label label(n, "YP6 step 4");
  const Wire sin_P = r.sine("N.SIN_P", P), sin_M = r.sine("N.SIN_M", M);
  n.output("N_turned.a", r.half_sum("N.a", sin_P, sin_M));
  return n;
}

Netlist illumination_unit(const YPoleParameters& p, const Material& material) {
  Netlist n("illumination");
  const Wire a = n.input("N_turned.a", p.half_word());
  const auto dot = [&](const std::string& name, const std::string& of) {
    const Wire G = n.input(of + "_turned.G", p.half_word()), rest = n.input(of + "_turned.rest", quarter_sum(p));
    const Netlist::Scope scope(n, name);
    return n.add("dot", n.mul("G_a", G, a, p.product(), "YP2"), rest, p.product(), "YP2");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::yp2
