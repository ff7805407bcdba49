#pragma once
// Errors in units in the last place, against long double mathematics, and values that are dense where functions are delicate.

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "datapath/lane_math.h"
#include "random_netlist.h"

namespace bump_test {

constexpr long double long_two_pi = 6.283185307179586476925286766559005768L;

/// |value - truth| in units in the last place of a double near the truth; 0 where both are NaN or the same infinity.
inline double ulps(double value, long double truth) {
  if (std::isnan(value) || std::isnan(truth)) return std::isnan(value) && std::isnan(truth) ? 0 : std::numeric_limits<double>::infinity();
  const auto rounded = static_cast<double>(truth);
  if (std::isinf(value) || std::isinf(rounded)) return value == rounded ? 0 : std::numeric_limits<double>::infinity();
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(1.0L, (rounded == 0 || exponent < -1021 ? -1021 : exponent) - 53);
  return static_cast<double>(std::fabs(value - truth) / unit);
}

/// The neighbours of a value, `count` either side.
inline void add_neighbours(std::vector<double>& values, double value, int count = 40) {
  double up = value, down = value;
  values.push_back(value);
  for (int i = 0; i < count; ++i) {
    values.push_back(up = std::nextafter(up, std::numeric_limits<double>::infinity()));
    values.push_back(down = std::nextafter(down, -std::numeric_limits<double>::infinity()));
  }
}

/// Of both signs: uniform in [0, largest], log-uniform down to subnormals, and the neighbours of zero and of every multiple of 1/8 up to 4.
inline std::vector<double> delicate_values(Random& random, double largest, int count) {
  std::vector<double> values{-0.0};
  const double top = std::log2(largest);
  for (int i = 0; i < count; ++i) {
    values.push_back(random.real(-largest, largest));
    values.push_back(random.real(-1, 1) * std::exp2(random.real(-30, std::min(top, 2.0))));
    values.push_back(random.real(-1, 1) * std::exp2(random.real(-1070, top)));
    const double near = random.integer(0, 32) * 0.125;
    values.push_back(near + random.real(-1, 1) * std::exp2(random.real(-50, -3)));
  }
  for (int i = -32; i <= 32; ++i) add_neighbours(values, i * 0.125);
  add_neighbours(values, std::numeric_limits<double>::min());
  std::vector<double> accepted;
  for (const double value : values)
    if (std::fabs(value) <= largest) accepted.push_back(value);
  return accepted;
}

}  // namespace bump_test
