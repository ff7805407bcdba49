#include "datapath/real_kernels.h"

#include <cmath>

#include "datapath/lane_clones.h"
#include "datapath/lane_math.h"

namespace bump::real_lanes {

BUMP_LANE_LOOP void wrap(double* __restrict x, int lanes) {
  for (int i = 0; i < lanes; ++i) x[i] = to_half_open_turn(x[i]);
}

BUMP_LANE_LOOP void add(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] + b[i];
}

BUMP_LANE_LOOP void subtract(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] - b[i];
}

BUMP_LANE_LOOP void add_or_subtract(const double* __restrict flags, const double* __restrict a, const double* __restrict b,
                                    double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] + (flags[i] != 0.0 ? -b[i] : b[i]);
}

BUMP_LANE_LOOP void multiply(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] * b[i];
}

BUMP_LANE_LOOP void divide(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] / b[i];
}

BUMP_LANE_LOOP void root(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = std::sqrt(a[i]);
}

BUMP_LANE_LOOP void add_turns(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = once_to_half_open_turn(a[i] + b[i]);
}

BUMP_LANE_LOOP void subtract_turns(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = once_to_half_open_turn(a[i] - b[i]);
}

BUMP_LANE_LOOP void negate_turns(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = once_to_half_open_turn(-a[i]);
}

BUMP_LANE_LOOP void add_half_turn(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = once_to_half_open_turn(a[i] + 0.5);
}

BUMP_LANE_LOOP void scale(const double* __restrict a, double factor, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] * factor;
}

BUMP_LANE_LOOP void scale_down_by(const double* __restrict a, const double* __restrict k, double* __restrict out, int lanes) {
  constexpr double furthest = 2044;  // takes any number of a datapath to 0; two factors, as one reaches half as far
  for (int i = 0; i < lanes; ++i) {
    const double number = k[i] == k[i] ? k[i] : 0.0;
    const double below = number < furthest ? number : furthest, places = below > -furthest ? below : -furthest;
    const double nearest = (places + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
    const double floor = nearest > places ? nearest - 1.0 : nearest;
    const auto upwards = static_cast<std::uint64_t>(narrow_of_double(floor + furthest));  // 0 to 4088
    const std::uint64_t first = upwards >> 1, second = upwards - first;
    const double scaled = a[i] * double_from_bits(static_cast<std::int64_t>((2045 - first) << 52)) *
                          double_from_bits(static_cast<std::int64_t>((2045 - second) << 52));
    out[i] = k[i] == k[i] ? scaled : k[i];
  }
}

BUMP_LANE_LOOP void negate(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = -a[i];
}

BUMP_LANE_LOOP void absolute(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = std::fabs(a[i]);
}

BUMP_LANE_LOOP void add_half(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] + 0.5;
}

BUMP_LANE_LOOP void clamp(const double* __restrict a, double low, double high, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double below = a[i] < high ? a[i] : high;
    out[i] = below > low ? below : low;
  }
}

BUMP_LANE_LOOP void select(const double* __restrict flags, const double* __restrict a, const double* __restrict b, double* __restrict out,
                           int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double if_set = a[i], if_clear = b[i];
    out[i] = flags[i] != 0.0 ? if_set : if_clear;
  }
}

BUMP_LANE_LOOP void is_negative(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] < 0.0 ? 1.0 : 0.0;
}

BUMP_LANE_LOOP void is_beyond_quarter(const double* __restrict a, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] > 0.25 || a[i] < -0.25 ? 1.0 : 0.0;
}

BUMP_LANE_LOOP void exclusive_or(const double* __restrict a, const double* __restrict b, double* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = (a[i] != 0.0) != (b[i] != 0.0) ? 1.0 : 0.0;
}

}  // namespace bump::real_lanes
