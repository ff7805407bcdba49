#include "schemes/lnsg/units.h"

#include "schemes/common/log_vector.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/y_pole_design.h"

namespace bump::lnsg {

Netlist environment_unit(const LnsgParameters& p) {
  Netlist n("environment");
  LogReads reads(n, p.logs());
  const Format in = p.input_angle();
  const PolarDirection normal = input_direction(n, "N", in), light = input_direction(n, "L", in), half = input_direction(n, "H", in);
  output_log_vector(n, "L", light, normal.phi, reads);
  output_log_vector(n, "H", half, normal.phi, reads);
  const MapAngles texel = map_angles(n, p);
  const Wire ph = turned_azimuth(n, texel.phi, p);
  const Netlist::Scope scope(n, "N");
  const Netlist::Label label(n, "LNSG step 2");
  const LogSineCosine of_theta = reads.both("LSC_THETA", normal.theta),
                      of_map = reads.both("LSC_MAP", n.shift("theta_g", texel.theta, 0, in)),
                      of_ph = reads.both("LSC_PH", n.shift("ph", ph, 0, in, "LNSG step 1"));
  const LogValue x = reads.product("log_x", of_map.sine, of_ph.cosine);
  LogValue x_sin = reads.product("log_x_sin", x, of_theta.sine);
  x_sin.negative = n.exclusive_or("x_sin_subtracted", x_sin.negative, n.constant("one", 1, flag()));
  output_log(n, "x_cos", reads.product("log_x_cos", x, of_theta.cosine));
  output_log(n, "x_sin", x_sin);
  output_log(n, "y", reads.product("log_y", of_map.sine, of_ph.sine));
  output_log(n, "z_sin", reads.product("log_z_sin", of_map.cosine, of_theta.sine));
  output_log(n, "z_cos", reads.product("log_z_cos", of_map.cosine, of_theta.cosine));
  return n;
}

Netlist illumination_unit(const LnsgParameters& p, const Material& material) {
  Netlist n("illumination");
  LogReads reads(n, p.logs());
  const LogWidths widths = p.logs();
  const int two_factors = widths.whole_bits + 1, three_factors = two_factors + 1;  // bits before the point
  const LogValue x_cos = input_log(n, "N.x_cos", widths, three_factors), x_sin = input_log(n, "N.x_sin", widths, three_factors),
                 y = input_log(n, "N.y", widths, two_factors), z_sin = input_log(n, "N.z_sin", widths, two_factors),
                 z_cos = input_log(n, "N.z_cos", widths, two_factors);
  const auto dot = [&](const std::string& name, const std::string& vector) {
    const LogVector a = input_log_vector(n, vector, widths);
    const auto product = [&](const char* term, const LogValue& of_a, const LogValue& of_normal) {
      return reads.product(name + "." + term, of_a, of_normal, "LNSG step 4");
    };
    return reads.sum(name,
                     {product("G_x", a.G, x_cos), product("z_x", a.z, x_sin), product("K_y", a.K, y), product("G_z", a.G, z_sin),
                      product("z_z", a.z, z_cos)},
                     "LNSG steps 3, 4");
  };
  const Wire n_l = dot("N_L", "L"), n_h = dot("N_H", "H");
  YPoleParameters light;
  light.light_table_bits = p.light_table_bits;
  light.light_word_bits = p.light_word_bits;
  output_intensity(n, n_l, n_h, light, material);
  return n;
}

}  // namespace bump::lnsg
