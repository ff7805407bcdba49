#include "datapath/narrow_kernels.h"

#include <cmath>

#include "datapath/lane_clones.h"
#include "datapath/lane_math.h"

namespace bump::narrow {

namespace {

/// Rounds to nearest, halves up, and leaves the integer in the low bits: those of the sum with 1.5 * 2^52, less nothing but plus one where
/// a half went down to the even neighbour. |scaled| < 2^51; only the low 32 bits are used.
inline std::int32_t low_bits_of_nearest(double scaled) {
  const double sum = scaled + one_and_a_half_times_two_to_52;
  const double even = sum - one_and_a_half_times_two_to_52;
  const std::int64_t up = scaled - even == 0.5 ? 1 : 0;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(bits_from_double(sum) + up)));
}

/// Words of one turn wrap by their low bits, whatever the number of whole turns. Returns whether every value was small enough for that.
BUMP_LANE_LOOP bool quantise_turns(const double* __restrict values, double scale, int unused, std::int32_t* __restrict words, int lanes) {
  std::int64_t large = 0;
  for (int i = 0; i < lanes; ++i) {
    large |= std::fabs(values[i]) < 65536.0 ? 0 : 1;
    const auto word = static_cast<std::uint32_t>(low_bits_of_nearest(values[i] * scale));
    words[i] = static_cast<std::int32_t>(word << unused) >> unused;
  }
  return large == 0;
}

BUMP_LANE_LOOP void quantise_numbers(const double* __restrict values, double scale, double lowest, double highest,
                                     std::int32_t* __restrict words, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double scaled = values[i] * scale;
    const double number = scaled == scaled ? scaled : 0.0;
    const double below = number < highest ? number : highest;
    words[i] = low_bits_of_nearest(below > lowest ? below : lowest);
  }
}

BUMP_LANE_LOOP void scale_words(const std::int32_t* __restrict words, double step, double* __restrict values, int lanes) {
  for (int i = 0; i < lanes; ++i) values[i] = static_cast<double>(words[i]) * step;
}

BUMP_LANE_LOOP void add_shifted(const std::int32_t* __restrict a, int left_a, const std::int32_t* __restrict b, int left_b, NarrowRule rule,
                                std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i)
    out[i] = rule.apply((static_cast<std::uint32_t>(a[i]) << left_a) + (static_cast<std::uint32_t>(b[i]) << left_b));
}
BUMP_LANE_LOOP void add_aligned(const std::int32_t* __restrict a, const std::int32_t* __restrict b, NarrowRule rule,
                                std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(static_cast<std::uint32_t>(a[i]) + static_cast<std::uint32_t>(b[i]));
}
BUMP_LANE_LOOP void add_exactly(const std::int32_t* __restrict a, const std::int32_t* __restrict b, std::int32_t* __restrict out,
                                int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(a[i]) + static_cast<std::uint32_t>(b[i]));
}
BUMP_LANE_LOOP void subtract_shifted(const std::int32_t* __restrict a, int left_a, const std::int32_t* __restrict b, int left_b,
                                     NarrowRule rule, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i)
    out[i] = rule.apply((static_cast<std::uint32_t>(a[i]) << left_a) - (static_cast<std::uint32_t>(b[i]) << left_b));
}
BUMP_LANE_LOOP void subtract_aligned(const std::int32_t* __restrict a, const std::int32_t* __restrict b, NarrowRule rule,
                                     std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(static_cast<std::uint32_t>(a[i]) - static_cast<std::uint32_t>(b[i]));
}
BUMP_LANE_LOOP void subtract_exactly(const std::int32_t* __restrict a, const std::int32_t* __restrict b, std::int32_t* __restrict out,
                                     int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(a[i]) - static_cast<std::uint32_t>(b[i]));
}

BUMP_LANE_LOOP void multiply_low(const std::int32_t* __restrict a, const std::int32_t* __restrict b, NarrowRule rule,
                                 std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(static_cast<std::uint32_t>(a[i]) * static_cast<std::uint32_t>(b[i]));
}
BUMP_LANE_LOOP void multiply_wide(const std::int32_t* __restrict a, const std::int32_t* __restrict b, int right, NarrowRule rule,
                                  std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int64_t product = static_cast<std::int64_t>(a[i]) * static_cast<std::int64_t>(b[i]);
    out[i] = rule.apply(static_cast<std::uint32_t>(static_cast<std::uint64_t>(product) >> right));
  }
}

BUMP_LANE_LOOP void divide_by_doubles(const std::int32_t* __restrict a, const std::int32_t* __restrict b, double scale, double highest,
                                      std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double dividend = std::fabs(static_cast<double>(a[i])) * scale, divisor = static_cast<double>(b[i]);
    const double nearest = (dividend / divisor + two_to_52) - two_to_52;
    const double quotient = dividend - nearest * divisor < 0 ? nearest - 1.0 : nearest;  // the product is an integer below 2^53: exact
    const double bounded = quotient < highest ? quotient : highest;                      // also by 0: infinite, or not a number
    const auto word =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(bits_from_double(bounded + two_to_52))));
    const std::int32_t sign = a[i] >> 31;
    out[i] = (word ^ sign) - sign;
  }
}

BUMP_LANE_LOOP void root_by_doubles(const std::int32_t* __restrict a, double scale, std::int32_t mask, std::int32_t* __restrict out,
                                    int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const double radicand = static_cast<double>(a[i]) * scale;
    const double nearest = (std::sqrt(radicand) + two_to_52) - two_to_52;
    const double floor = nearest * nearest > radicand ? nearest - 1.0 : nearest;
    out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(bits_from_double(floor + two_to_52)))) & mask;
  }
}

BUMP_LANE_LOOP void select_exactly(const std::int32_t* __restrict flags, const std::int32_t* __restrict a, const std::int32_t* __restrict b,
                                   std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = flags[i] != 0 ? a[i] : b[i];
}
BUMP_LANE_LOOP void select_rounded(const std::int32_t* __restrict flags, const std::int32_t* __restrict a, NarrowRule rule_a,
                                   const std::int32_t* __restrict b, NarrowRule rule_b, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int32_t if_set = rule_a.apply(static_cast<std::uint32_t>(a[i])), if_clear = rule_b.apply(static_cast<std::uint32_t>(b[i]));
    out[i] = flags[i] != 0 ? if_set : if_clear;
  }
}

}  // namespace

void quantise(const double* values, const Format& to, NarrowWords words, int lanes) {
  const double scale = std::ldexp(1.0, to.fraction);
  if (!to.wraps()) return quantise_numbers(values, scale, to.lowest() * scale, to.highest() * scale, words, lanes);
  if (quantise_turns(values, scale, 32 - to.width, words, lanes)) return;
  for (int i = 0; i < lanes; ++i) words[i] = static_cast<std::int32_t>(bump::quantise(values[i], to));
}

void to_double(ConstNarrowWords words, const Format& format, double* values, int lanes) {
  scale_words(words, format.step(), values, lanes);
}

BUMP_LANE_LOOP void widen(const std::int32_t* __restrict words, std::int64_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = words[i];
}

BUMP_LANE_LOOP void shrink(const std::int64_t* __restrict words, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(words[i])));
}

void add(ConstNarrowWords a, int left_a, ConstNarrowWords b, int left_b, NarrowRule rule, NarrowWords out, int lanes) {
  if (left_a + left_b > 0) return add_shifted(a, left_a, b, left_b, rule, out, lanes);
  if (rule.is_identity) return add_exactly(a, b, out, lanes);
  add_aligned(a, b, rule, out, lanes);
}

void subtract(ConstNarrowWords a, int left_a, ConstNarrowWords b, int left_b, NarrowRule rule, NarrowWords out, int lanes) {
  if (left_a + left_b > 0) return subtract_shifted(a, left_a, b, left_b, rule, out, lanes);
  if (rule.is_identity) return subtract_exactly(a, b, out, lanes);
  subtract_aligned(a, b, rule, out, lanes);
}

BUMP_LANE_LOOP void add_or_subtract(const std::int32_t* __restrict flags, const std::int32_t* __restrict a, int left_a,
                                    const std::int32_t* __restrict b, int left_b, NarrowRule rule, std::int32_t* __restrict out,
                                    int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const auto inverted = static_cast<std::uint32_t>(-flags[i]);
    const std::uint32_t second = static_cast<std::uint32_t>(b[i]) << left_b;
    out[i] = rule.apply((static_cast<std::uint32_t>(a[i]) << left_a) + ((second ^ inverted) - inverted));
  }
}

void multiply(ConstNarrowWords a, ConstNarrowWords b, int wide_right, NarrowRule rule, NarrowWords out, int lanes) {
  if (wide_right >= 0) return multiply_wide(a, b, wide_right, rule, out, lanes);
  multiply_low(a, b, rule, out, lanes);
}

void divide(ConstNarrowWords a, ConstNarrowWords b, DividerShape shape, NarrowWords out, int lanes) {
  divide_by_doubles(a, b, std::ldexp(1.0, shape.shift), std::ldexp(1.0, shape.magnitude) - 1, out, lanes);
}

void root(ConstNarrowWords a, RootShape shape, NarrowWords out, int lanes) {
  root_by_doubles(a, std::ldexp(1.0, shape.shift), static_cast<std::int32_t>((std::int64_t{1} << shape.magnitude) - 1), out, lanes);
}

BUMP_LANE_LOOP void move(const std::int32_t* __restrict a, NarrowRule rule, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(static_cast<std::uint32_t>(a[i]));
}

BUMP_LANE_LOOP void move_by(const std::int32_t* __restrict a, int left, const std::int32_t* __restrict k, NarrowRule rule,
                            std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int32_t places = k[i] < 31 ? k[i] : 31;  // all that is left of a word is its sign
    out[i] = rule.apply(static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<std::uint32_t>(a[i]) << left) >> places));
  }
}

BUMP_LANE_LOOP void negate(const std::int32_t* __restrict a, NarrowRule rule, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = rule.apply(0 - static_cast<std::uint32_t>(a[i]));
}

BUMP_LANE_LOOP void absolute(const std::int32_t* __restrict a, NarrowRule rule, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int32_t sign = a[i] >> 31;
    out[i] = rule.apply(static_cast<std::uint32_t>(a[i] ^ sign) - static_cast<std::uint32_t>(sign));
  }
}

BUMP_LANE_LOOP void half_turn(const std::int32_t* __restrict a, int width, std::int32_t* __restrict out, int lanes) {
  const int unused = 32 - width;
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int32_t>((static_cast<std::uint32_t>(a[i]) << unused) ^ 0x80000000u) >> unused;
}

BUMP_LANE_LOOP void clamp(const std::int32_t* __restrict a, int left, int right, std::int32_t low, std::int32_t high,
                          std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) {
    const std::int32_t word = static_cast<std::int32_t>(static_cast<std::uint32_t>(a[i]) << left) >> right;
    const std::int32_t above = word > low ? word : low;
    out[i] = above < high ? above : high;
  }
}

void select(ConstNarrowWords flags, ConstNarrowWords a, NarrowRule rule_a, ConstNarrowWords b, NarrowRule rule_b, NarrowWords out,
            int lanes) {
  if (rule_a.is_identity && rule_b.is_identity) return select_exactly(flags, a, b, out, lanes);
  select_rounded(flags, a, rule_a, b, rule_b, out, lanes);
}

BUMP_LANE_LOOP void is_negative(const std::int32_t* __restrict a, std::int32_t* __restrict out, int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(a[i]) >> 31);
}

BUMP_LANE_LOOP void is_beyond_quarter(const std::int32_t* __restrict a, int width, std::int32_t* __restrict out, int lanes) {
  const std::int32_t quarter = std::int32_t{1} << (width - 2);
  for (int i = 0; i < lanes; ++i) out[i] = (a[i] > quarter ? 1 : 0) | (a[i] < -quarter ? 1 : 0);
}

BUMP_LANE_LOOP void exclusive_or(const std::int32_t* __restrict a, const std::int32_t* __restrict b, std::int32_t* __restrict out,
                                 int lanes) {
  for (int i = 0; i < lanes; ++i) out[i] = a[i] ^ b[i];
}

}  // namespace bump::narrow
