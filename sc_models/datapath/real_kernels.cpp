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

}  // namespace bump::real_lanes
