#include "schemes/lns/units.h"

#include "schemes/common/log_vector.h"

namespace bump::lns {

Netlist environment_unit(const LnsParameters& p) {
  Netlist n("environment");
  LogReads reads(n, p.logs());
  const Format in = p.input_angle();
  const PolarDirection normal = input_direction(n, "N", in), light = input_direction(n, "L", in), half = input_direction(n, "H", in);
  output_log_vector(n, "L", light, normal.phi, reads);
  output_log_vector(n, "H", half, normal.phi, reads);
  const YPoleWires texel = y_pole_texel(n, p, p.turn());
  const Netlist::Scope scope(n, "N");
  const Netlist::Label label(n, "LNS step 5");
  const LogSineCosine of_Psi = reads.both("LSC_PSI", n.add("Psi", texel.psi, normal.theta, in, "LNS step 3")),
                      of_b = reads.both("LSC_B", texel.latitude);
  output_log(n, "x", reads.product("log_x", of_b.cosine, of_Psi.sine));
  output_log(n, "y", of_b.sine);
  output_log(n, "z", reads.product("log_z", of_b.cosine, of_Psi.cosine));
  return n;
}

Netlist illumination_unit(const LnsParameters& p, const Material& material) {
  Netlist n("illumination");
  LogReads reads(n, p.logs());
  const LogWidths widths = p.logs();
  const LogValue x = input_log(n, "N.x", widths, widths.whole_bits + 1), y = input_log(n, "N.y", widths, widths.whole_bits),
                 z = input_log(n, "N.z", widths, widths.whole_bits + 1);
  const auto dot = [&](const std::string& name, const std::string& vector) {
    const LogVector a = input_log_vector(n, vector, widths);
    const auto product = [&](const char* term, const LogValue& of_a, const LogValue& of_normal) {
      return reads.product(name + "." + term, of_a, of_normal, "LNS step 5");
    };
    return reads.sum(name, {product("G_x", a.G, x), product("K_y", a.K, y), product("z_z", a.z, z)}, "LNS steps 4, 5");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

}  // namespace bump::lns
