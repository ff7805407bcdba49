#include "schemes/lee2007/lee_parameters.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump::lee2007 {

void declare_parameters(Parameters& p) {
  p.choice("lee2007.form", "11", {"11", "13"},
           "adders of the illumination unit: 11 as in Table 1 (cosine squared of the half angle), 13 as in section 5.2");
  p.boolean("lee2007.half_xy", false, "halve X and Y as Eqs 5-6 are printed (an erratum: mean error 48 degrees)");
  p.choice("lee2007.eq16", "linear", {"linear", "exact"},
           "theta': the paper's linear Eq 16, or the spherical formula (1 multiplier less, 4 adders and 3 tables more a vector)");
  p.choice("lee2007.x_prime", "paper", {"paper", "exact"}, "x': the paper's sin(theta_x - theta_N), or the exact product form");
  p.boolean("lee2007.abs_fix", true, "take |y| and |Z| in Eqs 16 and 26");
  p.boolean("lee2007.quadrant_fix", true, "fold the arc tangent of Eq 9 over the full turn by the signs of y and sin Z");
  p.boolean("lee2007.hemisphere_bit", true, "unfold the arc sine of Eq 7 for vectors below the object's equator");
  p.integer("lee2007.angle_bits", 10, 6, 16, "bits", "bits of a full turn in the interpolated angles");
  p.integer("lee2007.table_bits", 8, 4, 12, "bits", "address bits of sine, cosine and reciprocal tables, for a quarter turn");
  p.integer("lee2007.inverse_table_bits", 8, 6, 12, "bits", "address bits of arc sine, arc tangent and proportion tables");
  p.integer("lee2007.word_bits", 16, 12, 20, "bits", "bits of a table word");
  p.integer("lee2007.light_table_bits", 10, 6, 12, "bits", "address bits of the diffuse and specular tables");
  p.integer("lee2007.texel_phi_bits", 8, 4, 12, "bits", "bits of phi in a bump texel, for a full turn");
  p.integer("lee2007.texel_theta_bits", 8, 4, 12, "bits", "bits of theta in a bump texel, for a quarter turn");
  p.choice("lee2007.map_filter", "nearest", {"nearest", "linear"},
           "bump texel: nearest, or filtered as two angles (phi is undefined on flat texels)");
  p.choice("lee2007.angles", "vertex", {"vertex", "pixel"},
           "polar angles: interpolated from the vertices, or formed per pixel from interpolated vectors");
  p.choice("lee2007.frame", "pixel", {"none", "face", "pixel"},
           "angle from e_theta to the tangent, added to phi of the map: none as the paper, one a face, or interpolated");
  p.boolean("lee2007.mirror", false, "carry one flag a triangle for mirrored texture charts, and negate phi of the map where it is set");
}

LeeParameters read_parameters(const Configuration& c) {
  LeeParameters p;
  p.form = c.choice("lee2007.form") == "11" ? 11 : 13;
  p.half_xy = c.boolean("lee2007.half_xy");
  p.exact_eq16 = c.choice("lee2007.eq16") == "exact";
  p.exact_x_prime = c.choice("lee2007.x_prime") == "exact";
  p.abs_fix = c.boolean("lee2007.abs_fix");
  p.quadrant_fix = c.boolean("lee2007.quadrant_fix");
  p.hemisphere_bit = c.boolean("lee2007.hemisphere_bit");
  p.angle_bits = static_cast<int>(c.integer("lee2007.angle_bits"));
  p.table_bits = static_cast<int>(c.integer("lee2007.table_bits"));
  p.inverse_table_bits = static_cast<int>(c.integer("lee2007.inverse_table_bits"));
  p.word_bits = static_cast<int>(c.integer("lee2007.word_bits"));
  p.light_table_bits = static_cast<int>(c.integer("lee2007.light_table_bits"));
  p.texel_phi_bits = static_cast<int>(c.integer("lee2007.texel_phi_bits"));
  p.texel_theta_bits = static_cast<int>(c.integer("lee2007.texel_theta_bits"));
  p.linear_filter = c.choice("lee2007.map_filter") == "linear";
  p.angles = c.choice("lee2007.angles") == "vertex" ? Angles::vertex : Angles::pixel;
  p.frame = c.choice("lee2007.frame") == "none" ? InPlane::none : c.choice("lee2007.frame") == "face" ? InPlane::face : InPlane::pixel;
  p.mirror = c.boolean("lee2007.mirror");
  return p;
}

double quantisation_floor_db(const LeeParameters& p, const Material& material) {
  constexpr double least = 3;  // what any two images of one scene keep
  // The paper's own formula jumps where a vector crosses the object's equator (the hemisphere bit changes theta_x to 180 - theta_x although
  // sx is not 1), and the uncorrected readings jump everywhere: a light on such a line gives two different images for angles that differ by
  // one rounding.
  const bool jumps = p.half_xy || !p.abs_fix || !p.quadrant_fix || (p.hemisphere_bit && !p.exact_x_prime);
  if (jumps) return least;
  const auto step = [](int bits) { return std::ldexp(1.0, -bits); };
  // Worst errors of a direction, in radians, by cause; the floor takes them as if every pixel had them at once.
  const double arrive = 4 * 3.15 * step(p.angle_bits);
  const double folded = 6 * 0.8 * step(p.table_bits);
  const double inverse = 1.5 * std::sqrt(step(p.inverse_table_bits)) + 4 * step(p.inverse_table_bits);
  const double words = 8 * step(p.word_bits - 8);
  const double texel = 3.15 * step(p.texel_phi_bits) + 0.8 * step(p.texel_theta_bits);
  const double direction = std::sqrt(arrive * arrive + folded * folded + inverse * inverse + words * words + texel * texel);
  return std::max(least, -20 * std::log10(direction * angular_slope(material) + light_table_error(material, p.light_table_bits)));
}

}  // namespace bump::lee2007
