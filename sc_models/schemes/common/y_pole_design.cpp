#include "schemes/common/y_pole_design.h"

#include <utility>

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/polar_vectors.h"

namespace bump {

void declare_y_pole_parameters(Parameters& p, const std::string& id, TexelAs texel) {
  declare_y_pole_settings(p, id, texel);
  declare_sum_widths(p, id);
}

void declare_sum_widths(Parameters& p, const std::string& id) {
  const YPoleParameters defaults;
  p.integer(id + ".table_bits", defaults.table_bits, 3, 12, "bits", "address bits of sine and cosine tables, for a quarter turn");
  p.integer(id + ".word_bits", defaults.word_bits, 4, 18, "bits", "bits of a table word");
  p.integer(id + ".light_table_bits", defaults.light_table_bits, 3, 12, "bits", "address bits of the diffuse and specular tables");
  p.integer(id + ".light_word_bits", defaults.light_word_bits, 4, 16, "bits", "bits of a word of the diffuse and specular tables");
  p.integer(id + ".ports", defaults.ports, 1, 2, "ports",
            "of a sine or cosine ROM: one index a cycle, or two, which halves the ROMs and changes no result");
}

YPoleParameters read_y_pole_parameters(const Configuration& c, const std::string& id, TexelAs texel) {
  YPoleParameters p;
  static_cast<YPoleSettings&>(p) = read_y_pole_settings(c, id, texel);
  p.table_bits = static_cast<int>(c.integer(id + ".table_bits"));
  p.word_bits = static_cast<int>(c.integer(id + ".word_bits"));
  p.light_table_bits = static_cast<int>(c.integer(id + ".light_table_bits"));
  p.light_word_bits = static_cast<int>(c.integer(id + ".light_word_bits"));
  p.ports = static_cast<int>(c.integer(id + ".ports"));
  return p;
}

Wire dot_of(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const YPoleParameters& p) {
  const Netlist::Scope scope(n, name);
  return dot_product(n, "dot", a, b, p.product(), p.product());
}

Wire dot_less_last(Netlist& n, const std::string& name, const VectorWires& a, const VectorWires& b, const YPoleParameters& p) {
  const Netlist::Scope scope(n, name);
  const auto times = [&](const char* result, Wire of_a, Wire of_b) { return n.mul(result, of_a, of_b, p.product()); };
  const Wire x = times("dot_x", a.x, b.x), y = times("dot_y", a.y, b.y), z = times("dot_z", a.z, b.z);
  return n.sub("dot", n.add("dot_xy", x, y, p.product()), z, p.product());
}

Netlist projected_illumination_unit(const YPoleParameters& p, const NormalFormats& normal, const Material& material) {
  Netlist n("illumination");
  const auto input_projected = [&](const std::string& name) -> VectorWires {
    const Wire G = n.input(name + ".G", p.half_word()), K = n.input(name + ".K", p.half_word());
    return {G, K, n.input(name + ".z", p.word())};
  };
  const VectorWires light = input_projected("L_turned"), half = input_projected("H_turned");
  const Wire a = n.input("N_turned.a", normal.a), s = n.input("N_turned.s", normal.s), c = n.input("N_turned.c", normal.c);
  const VectorWires bumped{a, s, c};
  const Netlist::Label label(n, "G a + K s + z c");
  const Wire n_l = dot_of(n, "N_L", light, bumped, p), n_h = dot_of(n, "N_H", half, bumped, p);
  output_intensity(n, n_l, n_h, p, material);
  return n;
}

void output_intensity(Netlist& n, Wire n_l, Wire n_h, const YPoleParameters& p, const Material& material) {
  const Netlist::Label label(n, "Lee Eq 2");
  const int fraction = n.format(n_l).fraction;
  const Format index = clamped_dot_format(fraction);
  const auto light = [&](const char* name, const TablePtr& table, const char* clamped, Wire dot) {
    return n.table(name, table, clamp_dot(n, clamped, dot, fraction)).front();
  };
  const Wire diffuse = light("DIFF", diffuse_table(index, p.light_table_bits, material, p.light_word_bits), "N_L.lit", n_l);
  const Wire specular = light("SPEC", specular_table(index, p.light_table_bits, material, p.light_word_bits), "N_H.lit", n_h);
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format(p.light_word_bits)));
}

double y_pole_floor_db(const YPoleParameters& p, const Material& material) {
  PolarSettings polar = p.polar();
  polar.map_filter = p.texel == TexelAs::angles ? MapFilter::nearest : MapFilter::vector;
  polar.texel_vector_bits = p.texel_bits;
  // As a texel of the same steps on the z pole: phi of a whole turn, theta of a quarter.
  polar.texel_phi_bits = p.texel_psi_bits + 1;
  polar.texel_theta_bits = p.texel_latitude_bits - 1;
  return light_word_floor_db(polar_floor_db(polar, {p.table_bits, p.word_bits, 0, p.light_table_bits}, material), p.light_word_bits);
}

Design y_pole_design(const YPoleParameters& p, Netlist environment, Netlist illumination, const Material& material) {
  Design design;
  record_polar_vectors(p.polar(), NormalAs::angles, design);
  design.environment = std::move(environment);
  design.illumination = std::move(illumination);
  design.map = y_pole_map(p);
  design.quantisation_floor_db = y_pole_floor_db(p, material);
  return design;
}

}  // namespace bump
