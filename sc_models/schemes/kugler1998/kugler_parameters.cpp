#include "schemes/kugler1998/kugler_parameters.h"

namespace bump::kugler1998 {

void declare_parameters(Parameters& p) {
  const KuglerParameters d;
  p.choice(
      "kugler1998.frame", "vertex", {"none", "face", "vertex", "pixel"},
      "psi, from e_theta to the tangent, added to phi of the bump: none, one a face, interpolated from the vertices, or formed per pixel "
      "from an interpolated tangent (a unit of its own, reported apart)");
  p.choice("kugler1998.map_holds", "angle", {"angle", "change"},
           "the map of bumps holds theta' as Table 1 of Lee 2007 leaves room for, or theta' less theta_N, which is one adder more");
  p.number("kugler1998.strength", d.strength, 0, 3.9, "", "factor of the bumps' tilt");
  p.number("kugler1998.max_tilt", d.max_tilt, 5, 89, "degrees",
           "largest tilt of a bump: that of the last code; steeper texels are stored as this");
  p.integer("kugler1998.angle_bits", d.angle_bits, 6, 16, "bits", "bits of a full turn in the angles between the tables");
  p.integer("kugler1998.table_bits", d.table_bits, 5, 13, "bits", "address bits of the tables of one index");
  p.integer("kugler1998.word_bits", d.word_bits, 6, 18, "bits", "fraction bits of sines, cosines and their products");
  p.integer("kugler1998.texel_phi_bits", d.texel_phi_bits, 3, 12, "bits", "bits of phi in a bump texel, for a full turn");
  p.integer("kugler1998.map_phi_bits", d.map_phi_bits, 3, 6, "bits", "address bits of phi_1 in the map of bumps, for half a turn");
  p.integer("kugler1998.map_theta_bits", d.map_theta_bits, 3, 7, "bits", "address bits of theta_N in the map of bumps, for a quarter turn");
  p.integer("kugler1998.map_tilt_bits", d.map_tilt_bits, 2, 5, "bits",
            "address bits of theta_b in the map of bumps, and its bits in a bump texel");
  p.integer("kugler1998.map_word_bits", d.map_word_bits, 6, 14, "bits", "bits of each of the two words of the map of bumps");
  p.integer("kugler1998.light_map_bits", d.light_map_bits, 11, 22, "bits", "address bits of each light map");
  p.integer("kugler1998.light_word_bits", d.light_word_bits, 4, 16, "bits", "bits of a light map's words");
  p.integer("kugler1998.light_integer_bits", d.light_integer_bits, 0, 4, "bits",
            "of those in front of the binary point: sums of lights beyond 2 to this power saturate");
}

KuglerParameters read_parameters(const Configuration& c) {
  KuglerParameters p;
  const std::string& frame = c.choice("kugler1998.frame");
  p.frame = frame == "none" ? Frame::none : frame == "face" ? Frame::face : frame == "vertex" ? Frame::vertex : Frame::pixel;
  p.map_holds = c.choice("kugler1998.map_holds") == "angle" ? MapHolds::angle : MapHolds::change;
  p.strength = c.number("kugler1998.strength");
  p.max_tilt = c.number("kugler1998.max_tilt");
  const auto bits = [&](const char* name) { return static_cast<int>(c.integer(std::string("kugler1998.") + name)); };
  p.angle_bits = bits("angle_bits");
  p.table_bits = bits("table_bits");
  p.word_bits = bits("word_bits");
  p.texel_phi_bits = bits("texel_phi_bits");
  p.map_phi_bits = bits("map_phi_bits");
  p.map_theta_bits = bits("map_theta_bits");
  p.map_tilt_bits = bits("map_tilt_bits");
  p.map_word_bits = bits("map_word_bits");
  p.light_map_bits = bits("light_map_bits");
  p.light_word_bits = bits("light_word_bits");
  p.light_integer_bits = bits("light_integer_bits");
  return p;
}

}  // namespace bump::kugler1998
