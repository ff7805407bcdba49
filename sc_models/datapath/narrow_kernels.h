#pragma once
// The loops of fixed-point evaluation for words that fit 32 bits: twice the lanes of lane_kernels.h in a vector register, half the memory.
// They compute modulo 2^32, which is exact where the bits that a result keeps lie within the low 32 of the exact value, or the exact value
// fits as a whole; narrow_rules.h decides that from the formats. Every loop is branch-free; results are those of lane_kernels.h.

#include <cstdint>

#include "datapath/arithmetic.h"
#include "datapath/format.h"

namespace bump {

/// Words of this many bits fit the narrow lanes.
inline bool fits_narrow_lane(const Format& format) {
  return format.width <= (format.is_signed ? 32 : 31);
}

/// The rounding rule of format.h on the low 32 bits of an exact value: up, then down with copies of the top bit, then a mask.
struct NarrowRule {
  int up = 0, down = 0;    ///< 0..31
  std::int32_t keep = -1;  ///< the bits of an unsigned result
  bool is_identity = false;

  std::int32_t apply(std::uint32_t exact) const { return (static_cast<std::int32_t>(exact << up) >> down) & keep; }
};

using NarrowWords = std::int32_t*;
using ConstNarrowWords = const std::int32_t*;

namespace narrow {

/// As quantise() does for formats that fit.
void quantise(const double* values, const Format& to, NarrowWords words, int lanes);
void to_double(ConstNarrowWords words, const Format& format, double* values, int lanes);
void widen(ConstNarrowWords words, std::int64_t* out, int lanes);
/// Words that fit.
void shrink(const std::int64_t* words, NarrowWords out, int lanes);

void add(ConstNarrowWords a, int left_a, ConstNarrowWords b, int left_b, NarrowRule rule, NarrowWords out, int lanes);
void subtract(ConstNarrowWords a, int left_a, ConstNarrowWords b, int left_b, NarrowRule rule, NarrowWords out, int lanes);
/// The difference where the flag is set, else the sum.
void add_or_subtract(ConstNarrowWords flags, ConstNarrowWords a, int left_a, ConstNarrowWords b, int left_b, NarrowRule rule,
                     NarrowWords out, int lanes);
/// `wide_right` >= 0: the product takes 64 bits and is shifted that far, at most 32, before the rule.
void multiply(ConstNarrowWords a, ConstNarrowWords b, int wide_right, NarrowRule rule, NarrowWords out, int lanes);
/// Dividend, divisor and quotient below 2^50; shape.shift >= 0; at most 31 quotient bits kept.
void divide(ConstNarrowWords a, ConstNarrowWords b, DividerShape shape, NarrowWords out, int lanes);
/// Radicand below 2^50; shape.shift >= 0.
void root(ConstNarrowWords a, RootShape shape, NarrowWords out, int lanes);
void move(ConstNarrowWords a, NarrowRule rule, NarrowWords out, int lanes);
/// rule(floor(a * 2^(left - k))); a * 2^left fits.
void move_by(ConstNarrowWords a, int left, ConstNarrowWords k, NarrowRule rule, NarrowWords out, int lanes);
void negate(ConstNarrowWords a, NarrowRule rule, NarrowWords out, int lanes);
void absolute(ConstNarrowWords a, NarrowRule rule, NarrowWords out, int lanes);
void half_turn(ConstNarrowWords a, int width, NarrowWords out, int lanes);
void clamp(ConstNarrowWords a, int left, int right, std::int32_t low, std::int32_t high, NarrowWords out, int lanes);
void select(ConstNarrowWords flags, ConstNarrowWords a, NarrowRule rule_a, ConstNarrowWords b, NarrowRule rule_b, NarrowWords out,
            int lanes);
void is_negative(ConstNarrowWords a, NarrowWords out, int lanes);
void is_beyond_quarter(ConstNarrowWords a, int width, NarrowWords out, int lanes);
void exclusive_or(ConstNarrowWords a, ConstNarrowWords b, NarrowWords out, int lanes);

}  // namespace narrow

}  // namespace bump
