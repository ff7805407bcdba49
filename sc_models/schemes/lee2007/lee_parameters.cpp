#include "schemes/lee2007/lee_parameters.h"

#include "schemes/common/light_tables.h"
#include "schemes/common/polar_error.h"

namespace bump::lee2007 {

void declare_parameters(Parameters& p) {
  const char* const reading = "which formulas are the paper's; lee2007_corrected is the scheme with its mistakes mended";
  p.choice("lee2007.form", "11", {"11", "13"},
           "adders of the illumination unit: 11 as in Table 1 (cosine squared of the half angle), 13 as in section 5.2");
  p.boolean("lee2007.half_xy", false, "halve X and Y as Eqs 5-6 are printed (an erratum: mean error 48 degrees)").decides = reading;
  p.choice("lee2007.eq16", "linear", {"linear", "exact"},
           "theta': the paper's linear Eq 16, or the spherical formula (a vector: 1 multiplier less, 2 adders and 3 tables more)")
      .decides = reading;
  p.choice("lee2007.x_prime", "paper", {"paper", "exact"}, "x': the paper's sin(theta_x - theta_N), or the exact product form").decides =
      reading;
  p.boolean("lee2007.abs_fix", true, "take |y| and |Z| in Eqs 16 and 26").decides = reading;
  p.boolean("lee2007.quadrant_fix", true, "fold the arc tangent of Eq 9 over the full turn by the signs of y and sin Z").decides = reading;
  p.boolean("lee2007.hemisphere_bit", true, "unfold the arc sine of Eq 7 for vectors below the object's equator").decides = reading;
  declare_polar_settings(p, "lee2007", LeeParameters{});
  declare_in_plane_settings(p, "lee2007");
  p.integer("lee2007.table_bits", 8, 3, 12, "bits", "address bits of sine, cosine and reciprocal tables, for a quarter turn");
  p.integer("lee2007.inverse_table_bits", 8, 4, 12, "bits", "address bits of arc sine, arc tangent and proportion tables");
  p.integer("lee2007.word_bits", 16, 10, 20, "bits", "bits of a table word");
  p.integer("lee2007.light_table_bits", 10, 3, 12, "bits", "address bits of the diffuse and specular tables");
  p.integer("lee2007.light_word_bits", 16, 4, 16, "bits", "bits of a word of the light tables, one before the point");
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
  read_polar_settings(c, "lee2007", p);
  read_in_plane_settings(c, "lee2007", p);
  p.table_bits = static_cast<int>(c.integer("lee2007.table_bits"));
  p.inverse_table_bits = static_cast<int>(c.integer("lee2007.inverse_table_bits"));
  p.word_bits = static_cast<int>(c.integer("lee2007.word_bits"));
  p.light_table_bits = static_cast<int>(c.integer("lee2007.light_table_bits"));
  p.light_word_bits = static_cast<int>(c.integer("lee2007.light_word_bits"));
  return p;
}

double quantisation_floor_db(const LeeParameters& p, const Material& material) {
  // The corrected formula jumps where a vector crosses the object's equator (Design::jumps says so). The uncorrected readings jump
  // everywhere: a light on such a line gives two different images for angles that differ by one rounding.
  const bool jumps = p.half_xy || !p.abs_fix || !p.quadrant_fix;
  if (jumps) return 3;  // what any two images of one scene keep
  return light_word_floor_db(polar_floor_db(p, {p.table_bits, p.word_bits, 8, p.light_table_bits}, material), p.light_word_bits);
}

}  // namespace bump::lee2007
