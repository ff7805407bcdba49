#include "schemes/common/log_error.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump {

double logarithmic_floor_db(double floor_db, const LogWidths& w, int factors, int terms, const Material& material) {
  constexpr double ln_2 = 0.693147180559945309417;
  const auto half_step = [](int bits) { return std::ldexp(0.5, -bits); };
  // Relative errors of a product: a word for every factor, then the antilogarithm's neighbourhood and word (at least 1/2).
  const double relative = ln_2 * (factors * half_step(w.log_bits) + half_step(w.antilog_bits)) + 2 * half_step(w.word_bits);
  // A factor too small for its word counts as the least that the word holds.
  const double saturated = w.whole_bits < log_whole_bits ? std::ldexp(1.0, -(1 << w.whole_bits)) : 0;
  const double error = terms * (relative + std::ldexp(1.0, -w.word_bits - 2) + saturated);
  return std::max(3.0, -20 * std::log10(std::pow(10.0, -floor_db / 20) + error * angular_slope(material)));
}

}  // namespace bump
