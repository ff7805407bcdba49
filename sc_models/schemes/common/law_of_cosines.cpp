#include "schemes/common/law_of_cosines.h"

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump {

CosineTables cosine_tables(const LawOfCosines& f) {
  return {cosine_table("COS", f.inner_angle(), f.table_bits, f.word_bits),
          cosine_half_squared_table("COS2HALF", f.inner_angle(), f.table_bits, f.word_bits)};
}

Wire law_of_cosines(Netlist& n, Wire phi, Wire theta, Wire map_phi, Wire map_theta, const LawOfCosines& f, const CosineTables& t,
                    const std::string& equation) {
  const Format inner = f.inner_angle(), sum = sfixed(f.word_bits + 2, f.word_bits);
  const Wire u = n.table("COS_DIFFERENCE", t.cosine, n.sub("theta_difference", theta, map_theta, inner, equation), equation).front();
  const Wire v = n.table("COS_SUM", t.cosine, n.add("theta_sum", theta, map_theta, inner, equation), equation).front();
  const Wire dp = n.sub("phi_difference", phi, map_phi, inner, equation);
  const Wire u_less_v = n.sub("u_less_v", u, v, sum, equation);
  if (f.form == 11) {
    const Wire c2 = n.table("COS2HALF", t.cosine_half_squared, dp, equation).front();
    return n.add("dot", v, n.mul("share", u_less_v, c2, sum, equation), sum, equation);
  }
  const Wire c = n.table("COS_PHI", t.cosine, dp, equation).front();
  const Format doubled = sfixed(f.word_bits + 3, f.word_bits);
  const Wire twice =
      n.add("twice_dot", n.add("u_plus_v", u, v, sum, equation), n.mul("share", u_less_v, c, sum, equation), doubled, equation);
  return n.shift("dot", twice, -1, sfixed(f.word_bits + 3, f.word_bits + 1), equation);
}

Netlist law_of_cosines_unit(const LawOfCosines& f, const PolarSettings& p, const Material& material) {
  Netlist n("illumination");
  const auto reference = [&](const std::string& name) { return n.input(name, f.inner_angle()); };
  const Wire light_phi = reference("L_ref.phi"), light_theta = reference("L_ref.theta");
  const Wire half_phi = reference("H_ref.phi"), half_theta = reference("H_ref.theta");
  const Wire map_phi = n.input("map.phi", p.map_phi()), map_theta = n.input("map.theta", p.map_theta());
  const Wire phi = turned_azimuth(n, map_phi, p);
  const CosineTables tables = cosine_tables(f);
  const auto clamped_dot = [&](const std::string& name, Wire vector_phi, Wire vector_theta, const std::string& equation) {
    const Netlist::Scope scope(n, name);
    const Netlist::Label label(n, equation);
    return clamp_dot(n, "lit", law_of_cosines(n, vector_phi, vector_theta, phi, map_theta, f, tables, equation), f.word_bits);
  };
  const Wire n_l = clamped_dot("N_L", light_phi, light_theta, "Eq 24");
  const Wire n_h = clamped_dot("N_H", half_phi, half_theta, "Eq 25");
  const Format index = clamped_dot_format(f.word_bits);
  const Wire diffuse = n.table("DIFF", diffuse_table(index, f.light_table_bits, material, f.light_word_bits), n_l, "Eq 2").front();
  const Wire specular = n.table("SPEC", specular_table(index, f.light_table_bits, material, f.light_word_bits), n_h, "Eq 2").front();
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format(f.light_word_bits), "Eq 2"));
  return n;
}

}  // namespace bump
