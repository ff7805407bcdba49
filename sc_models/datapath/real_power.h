#pragma once
// x^n of double-precision evaluation, for specular highlights: branch-free like real_turns.h, and for the same reasons. The binary
// logarithm is a sum of two doubles that together are good to 2^-65, because the exponential turns its absolute error into a relative one;
// the scheme is that of fdlibm's e_pow.c (one division, products of halves without rounding), with the mantissa in one interval instead of
// two and the exponential a polynomial. Error below 1.5 units in the last place (testbench/tests/datapath/test_real_power.cpp). Timing:
// none, host arithmetic.

#include <limits>

#include "datapath/lane_math.h"

namespace bump {

/// log2 x as a sum; `top` has 26 bits.
struct BinaryLogarithm {
  double top, rest;
};

/// Of finite x > 0; other x give some number.
BUMP_LANE_FUNCTION BinaryLogarithm binary_logarithm(double x) {
  constexpr double lowest_normal = std::numeric_limits<double>::min();
  // x = m 2^e with m in [sqrt 1/2, sqrt 2).
  const bool subnormal = x < lowest_normal;
  const std::int64_t bits = bits_from_double(subnormal ? x * 0x1p54 : x), root_half = 0x3fe6a09e667f3bcd;
  const std::int64_t field =
      static_cast<std::int64_t>((static_cast<std::uint64_t>(bits - root_half + (std::int64_t{1} << 62))) >> 52) - 1024;
  const double m = double_from_bits(bits - static_cast<std::int64_t>(static_cast<std::uint64_t>(field) << 52));
  const double e = double_of_narrow(field) - (subnormal ? 54 : 0);
  // q = (m - 1) / (m + 1) = q_top + q_rest; log m = 2 (q + q^3 / 3 + ...) = 2/3 q (3 + q^2 + q^4 of_log).
  constexpr double of_log[] = {0x1.3333333333333p-1, 0x1.b6db6db6db7b2p-2, 0x1.555555552ff8cp-2, 0x1.1745d19bf0840p-2,
                               0x1.d89d60bb25922p-3, 0x1.99a52bd708da3p-3, 0x1.679d96ac7bbebp-3, 0x1.6822d3ff5dac6p-3};
  const double difference = m - 1, reciprocal = 1 / (m + 1), q = difference * reciprocal, q_top = top_half(q);
  const double sum_top = top_half(m + 1), sum_rest = m - (sum_top - 1);
  const double q_rest = reciprocal * ((difference - q_top * sum_top) - q_top * sum_rest);
  const double qq = q * q, top_squared = q_top * q_top;
  const double tail = qq * qq * polynomial(of_log, qq) + q_rest * (q_top + q);
  const double series_top = top_half(3 + top_squared + tail), series_rest = tail - ((series_top - 3) - top_squared);
  const double u = q_top * series_top, v = q_rest * series_top + series_rest * q;
  const double product_top = top_half(u + v), product_rest = v - (product_top - u);
  // Times 2 / (3 ln 2), and the exponent to it: the binary logarithm.
  constexpr double factor_top = 0x1.ec709d8p-1, factor_rest = 0x1.0e80ff5d27f05p-27, factor = 0x1.ec709dc3a03fdp-1;
  const double log_top_part = factor_top * product_top, log_rest_part = factor_rest * product_top + product_rest * factor;
  const double log_top = top_half((log_top_part + log_rest_part) + e);
  return {log_top, log_rest_part - ((log_top - e) - log_top_part)};
}

/// x^n by the logarithm of x; x decides where there is none.
BUMP_LANE_FUNCTION double power_by_logarithm(BinaryLogarithm log, double x, double n) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // n log2 x = whole + z, |z| at most a little above 1/2, or out of range and replaced below.
  const double n_top = top_half(n);
  const double leading = n_top * log.top, following = (n - n_top) * log.top + n * log.rest;
  const double both = leading + following;
  const double bounded = both > 1024 ? 1024 : both > -1080 ? both : -1080;
  const double whole = (bounded + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
  const double near = leading - whole, z = near + following;
  // 2^z = exp(w + w_rest).
  constexpr double ln2_top = 0x1.62e42f8p-1, ln2_rest = 0x1.be8e7bcd5e4f2p-27, ln2 = 0x1.62e42fefa39efp-1;
  constexpr double of_exp[] = {0x1.0000000000001p-1,  0x1.5555555555556p-3,  0x1.5555555553d37p-5,  0x1.11111111109a6p-7,
                               0x1.6c16c1789d1d7p-10, 0x1.a01a01a7cebcdp-13, 0x1.a019b8ca26fcfp-16, 0x1.71de0d85293b8p-19,
                               0x1.2891d4ffbb0f9p-22, 0x1.af390ba7e6f47p-26};
  const double z_top = top_half(z), z_rest = following - (z_top - near);
  const double w_top = z_top * ln2_top, w_rest = z_top * ln2_rest + z_rest * ln2, w = w_top + w_rest;
  const double exponential = 1 + (w_top + (w_rest + w * w * polynomial(of_exp, w)));
  // Two factors: one alone cannot reach the subnormals.
  const std::int64_t power_of_two = narrow_of_double(whole), first = narrow_of_double(round_half_up(0.5 * whole));
  const double scale = double_from_bits((first + 1023) << 52), other = double_from_bits((power_of_two - first + 1023) << 52);
  const double in_range = exponential * scale * other;
  const double scaled = both > 1024 ? infinity : both > -1080 ? in_range : 0;
  const double at_zero = n > 0 ? 0 : infinity, at_infinity = n > 0 ? infinity : 0;
  const double defined = x > 0 ? (x < infinity ? scaled : at_infinity) : x == 0 ? at_zero : std::numeric_limits<double>::quiet_NaN();
  return n == 0 ? 1 : defined;
}

/// x >= 0 (negative x gives NaN), |n| <= 2^20. 0^n is 0 for positive n; 0^0 is 1, as for every x.
BUMP_LANE_FUNCTION double power(double x, double n) {
  return power_by_logarithm(binary_logarithm(x), x, n);
}

}  // namespace bump
