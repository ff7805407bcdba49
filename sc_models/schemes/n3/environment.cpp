#include "schemes/n3/environment.h"

#include "schemes/common/inverse_tables.h"
#include "schemes/common/object_angles_tables.h"
#include "schemes/common/polar_rotation.h"
#include "schemes/common/rom_ports.h"

namespace bump::n3 {

Netlist environment_unit(const ObjectAnglesParameters& p) {
  Netlist n("environment");
  const Format in = p.input_angle(), inner = p.inner_angle();
  const int w = p.word_bits, fine = w + pole_bits, k = p.table_bits;
  const PolarDirection normal = input_direction(n, "N", in);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  RomPorts sine_cosine(scaled_sine_cosine_table("SC", in, k, {w, 1}, {fine, 1}), p.ports);
  Netlist::Label label(n, "N3 step 3");
  const Wire Psi = n.add("N.Psi", texel.psi, normal.theta, in, "N3 step 2");
  const std::vector<Wire> of_P = sine_cosine.read(n, "N.SC_P", n.add("N.P", Psi, texel.latitude, in)),
                          of_M = sine_cosine.read(n, "N.SC_M", n.sub("N.M", Psi, texel.latitude, in));
  const Wire s = n.table("N.SIN_B", scaled_sine_table("SIN", in, k, {w, 1}), texel.latitude, "N3 step 2").front();
  const auto half_sum = [&](const std::string& name, Wire a, Wire b, int fraction) {
    return n.shift(name, n.add("twice_" + name, a, b, sfixed(fraction + 2, fraction)), -1, sfixed(fraction + 2, fraction + 1));
  };
  const Wire a = half_sum("N_a", of_P[0], of_M[0], w), c = half_sum("N_c", of_P[1], of_M[1], fine);
  label.next("N3 step 4");
  const Wire longitude = azimuth(n, "longitude", s, a, azimuth_formats(w + 1, p.inverse_table_bits, w, inner));
  n.output("N_object.phi", n.add("phi", longitude, normal.phi, inner));
  n.output("N_object.theta", polar_arc_cosine(n, "theta", c, p.inverse_table_bits, w, inner));
  return n;
}

}  // namespace bump::n3
