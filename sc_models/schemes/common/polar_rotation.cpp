#include "schemes/common/polar_rotation.h"

#include <utility>

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_error.h"
#include "schemes/common/polar_map.h"
#include "schemes/common/polar_vectors.h"
#include "schemes/common/trigonometric_tables.h"

namespace bump {

void declare_rotation_parameters(Parameters& p, const std::string& id) {
  RotationParameters defaults;
  defaults.angle_bits = 12;
  declare_polar_settings(p, id, defaults);
  declare_in_plane_settings(p, id);
  p.choice(id + ".form", "11", {"11", "13"}, "adders of the illumination unit: 11 as in Table 1 of Lee 2007, 13 as in its section 5.2");
  p.integer(id + ".table_bits", defaults.table_bits, 3, 12, "bits", "address bits of sine and cosine tables, for a quarter turn");
  p.integer(id + ".inverse_table_bits", 10, 4, 14, "bits", "address bits of arc cosine, arc tangent, reciprocal tables");
  p.integer(id + ".word_bits", defaults.word_bits, 4, 18, "bits", "bits of a table word");
  p.integer(id + ".light_table_bits", defaults.light_table_bits, 3, 12, "bits", "address bits of the diffuse and specular tables");
  p.integer(id + ".light_word_bits", 16, 4, 16, "bits", "bits of a word of the light tables, one before the point");
}

RotationParameters read_rotation_parameters(const Configuration& c, const std::string& id) {
  RotationParameters p;
  read_polar_settings(c, id, p);
  read_in_plane_settings(c, id, p);
  p.form = c.choice(id + ".form") == "11" ? 11 : 13;
  p.table_bits = static_cast<int>(c.integer(id + ".table_bits"));
  p.inverse_table_bits = static_cast<int>(c.integer(id + ".inverse_table_bits"));
  p.word_bits = static_cast<int>(c.integer(id + ".word_bits"));
  p.light_table_bits = static_cast<int>(c.integer(id + ".light_table_bits"));
  p.light_word_bits = static_cast<int>(c.integer(id + ".light_word_bits"));
  return p;
}

PolarDirection input_direction(Netlist& n, const std::string& name, const Format& format) {
  const Wire phi = n.input(name + ".phi", format);
  return {phi, n.input(name + ".theta", format)};
}

RotationTables rotation_tables(const RotationParameters& p) {
  const int w = p.word_bits;
  RotationTables t;
  t.sine_cosine = sine_cosine_table("SC", p.input_angle(), p.table_bits, w);
  t.arc_cosine = arc_cosine_table("ACOS", sfixed(w + 2, w + 1), p.inverse_table_bits, uangle(w, w + 2));
  t.azimuth = azimuth_formats(w + 1, p.inverse_table_bits, w, p.inner_angle());
  return t;
}

void output_reference(Netlist& n, const std::string& name, Wire x, Wire y, Wire z, const RotationParameters& p, const RotationTables& t) {
  n.output(name + "_ref.phi", azimuth(n, name + ".phi_ref", y, x, t.azimuth, "phi' = atan2(y', x')"));
  n.output(name + "_ref.theta", arc_cosine(n, name + ".theta_ref", z, t.arc_cosine, p.inner_angle(), "theta' = acos z'"));
}

Design rotation_design(const RotationParameters& p, Netlist environment, const Material& material) {
  Design design;
  record_polar_vectors(p, NormalAs::angles, design);
  design.environment = std::move(environment);
  design.illumination = law_of_cosines_unit(p.illumination(), p, material);
  design.map = polar_map(p);
  using Of = DeliveredDirection::Of;
  design.directions = {{Of::light, DeliveredDirection::Frame::polar, {"L_ref.phi", "L_ref.theta"}},
                       {Of::half, DeliveredDirection::Frame::polar, {"H_ref.phi", "H_ref.theta"}}};
  // A reciprocal's word spends 8 of word_bits + 4 bits on its integer part.
  design.quantisation_floor_db =
      light_word_floor_db(polar_floor_db(p, {p.table_bits, p.word_bits, 4, p.light_table_bits}, material), p.light_word_bits);
  return design;
}

}  // namespace bump
