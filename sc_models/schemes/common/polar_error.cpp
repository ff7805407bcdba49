#include "schemes/common/polar_error.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump {

namespace {

double step(int bits) {
  return std::ldexp(1.0, -bits);
}

double texel_error(const PolarSettings& s) {
  if (s.map_filter != MapFilter::vector) return 3.15 * step(s.texel_phi_bits) + 0.8 * step(s.texel_theta_bits);
  return 2 * step(s.texel_vector_bits) + 2 * 3.15 * step(s.angle_bits) + step(s.inverse_table_bits);
}

}  // namespace

double polar_floor_db(const PolarSettings& s, const PolarWidths& w, const Material& material) {
  const double arrive = 4 * 3.15 * step(s.angle_bits);
  const double folded = 6 * 0.8 * step(w.table_bits);
  // Arc sine and arc cosine are steep at their ends, where an angle errs by the root of what the cosine does.
  const double inverse = 1.5 * std::sqrt(step(s.inverse_table_bits)) + 4 * step(s.inverse_table_bits);
  const double words = 8 * step(w.word_bits - w.word_integer_bits);
  const double texel = texel_error(s);
  const double direction = std::sqrt(arrive * arrive + folded * folded + inverse * inverse + words * words + texel * texel);
  return std::max(3.0, -20 * std::log10(direction * angular_slope(material) + light_table_error(material, w.light_table_bits)));
}

}  // namespace bump
