#include "schemes/nc2/environment.h"

#include "schemes/common/object_angles_tables.h"
#include "schemes/common/polar_rotation.h"
#include "schemes/common/rom_ports.h"

namespace bump::nc2 {

namespace {

constexpr int guard_bits = 4;  // of components and angles: every stage floors once

}  // namespace

CordicWidths Nc2Parameters::cordic() const {
  const int fraction = word_bits + 1 + guard_bits;
  return {stages, sfixed(fraction + 3, fraction), turns(word_bits + 2 + guard_bits)};
}

Netlist environment_unit(const Nc2Parameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle(), inner = p.inner_angle();
  const int w = p.word_bits;
  const CordicWidths cordic = p.cordic();
  const double shrink = 1 / cordic_gain(p.stages);
  const PolarDirection normal = input_direction(n, "N", in);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  RomPorts sine_cosine(scaled_sine_cosine_table("SC", in, p.table_bits, {w, shrink}, {w, 1}), p.ports);
  const Netlist::Label label(n, "N3 step 3");
  const Wire Psi = n.add("N.Psi", texel.psi, normal.theta, in, "N3 step 2");
  const std::vector<Wire> of_P = sine_cosine.read(n, "N.SC_P", n.add("N.P", Psi, texel.latitude, in)),
                          of_M = sine_cosine.read(n, "N.SC_M", n.sub("N.M", Psi, texel.latitude, in));
  const Wire s = n.table("N.SIN_B", scaled_sine_table("SIN", in, p.table_bits, {w, shrink}), texel.latitude, "N3 step 2").front();
  const auto half_sum = [&](const std::string& name, Wire a, Wire b) {
    return n.shift(name, n.add("twice_" + name, a, b, sfixed(w + 2, w)), -1, sfixed(w + 2, w + 1));
  };
  const CordicPolar azimuth = cordic_polar(n, "phi", half_sum("N_a", of_P[0], of_M[0]), s, normal.phi, cordic);
  const Wire theta = cordic_angle(n, "theta", half_sum("N_c", of_P[1], of_M[1]), azimuth.length, cordic);
  n.output("N_object.phi", n.shift("phi_word", azimuth.angle, 0, inner, "NC2 step 2"));
  n.output("N_object.theta", n.shift("theta_word", theta, 0, inner, "NC2 step 4"));
  return n;
}

}  // namespace bump::nc2
