#include "schemes/lee2007/illumination.h"

#include <algorithm>

#include "schemes/common/light_tables.h"
#include "schemes/common/trigonometric_tables.h"
#include "schemes/lee2007/tables.h"

namespace bump::lee2007 {

namespace {

/// phi of the map in the frame that the rotation delivers: one adder that the paper omits (and sign logic for mirrored charts).
Wire turned_azimuth(Netlist& n, Wire phi, const LeeParameters& p) {
  n.begin_addition();
  if (p.mirror)
    phi = n.select("phi_unmirrored", n.is_negative("is_mirrored", n.input("mirror", turns(2))),
                   n.negate("phi_mirrored", phi, p.texel_phi()), phi, p.texel_phi());
  if (p.frame != InPlane::none)
    phi = n.add("phi_turned", phi, n.input("alpha", p.input_angle()), turns(std::max(p.texel_phi_bits, p.angle_bits)));
  n.end_addition();
  return phi;
}

/// N'.V by Eq 24 or 25, in [-1, 1].
Wire law_of_cosines(Netlist& n, Wire phi, Wire theta, Wire map_phi, Wire map_theta, const LeeParameters& p, const IlluminationTables& t,
                    const std::string& equation) {
  const Format inner = p.inner_angle(), sum = sfixed(p.word_bits + 2, p.word_bits);
  const Wire u = n.table("COS_DIFFERENCE", t.cosine, n.sub("theta_difference", theta, map_theta, inner, equation), equation).front();
  const Wire v = n.table("COS_SUM", t.cosine, n.add("theta_sum", theta, map_theta, inner, equation), equation).front();
  const Wire dp = n.sub("phi_difference", phi, map_phi, inner, equation);
  const Wire u_less_v = n.sub("u_less_v", u, v, sum, equation);
  if (p.form == 11) {
    const Wire c2 = n.table("COS2HALF", t.cosine_half_squared, dp, equation).front();
    return n.add("dot", v, n.mul("share", u_less_v, c2, sum, equation), sum, equation);
  }
  const Wire c = n.table("COS_PHI", t.cosine, dp, equation).front();
  const Format doubled = sfixed(p.word_bits + 3, p.word_bits);
  const Wire twice =
      n.add("twice_dot", n.add("u_plus_v", u, v, sum, equation), n.mul("share", u_less_v, c, sum, equation), doubled, equation);
  return n.shift("dot", twice, -1, sfixed(p.word_bits + 3, p.word_bits + 1), equation);
}

}  // namespace

Netlist illumination_unit(const LeeParameters& p, const Material& material) {
  Netlist n("illumination");
  const auto reference = [&](const std::string& name) { return n.input(name, p.inner_angle()); };
  const Wire light_phi = reference("L_ref.phi"), light_theta = reference("L_ref.theta");
  const Wire half_phi = reference("H_ref.phi"), half_theta = reference("H_ref.theta");
  const Wire map_phi = n.input("map.phi", p.texel_phi()), map_theta = n.input("map.theta", p.texel_theta());
  const Wire phi = turned_azimuth(n, map_phi, p);
  const IlluminationTables tables = illumination_tables(p);
  const auto clamped_dot = [&](const std::string& name, Wire vector_phi, Wire vector_theta, const std::string& equation) {
    const Netlist::Scope scope(n, name);
    return clamp_dot(n, "lit", law_of_cosines(n, vector_phi, vector_theta, phi, map_theta, p, tables, equation), p.word_bits);
  };
  const Wire n_l = clamped_dot("N_L", light_phi, light_theta, "Eq 24");
  const Wire n_h = clamped_dot("N_H", half_phi, half_theta, "Eq 25");
  const Format index = clamped_dot_format(p.word_bits);
  const Wire diffuse = n.table("DIFF", diffuse_table(index, p.light_table_bits, material), n_l, "Eq 2").front();
  const Wire specular = n.table("SPEC", specular_table(index, p.light_table_bits, material), n_h, "Eq 2").front();
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format(), "Eq 2"));
  return n;
}

}  // namespace bump::lee2007
