#pragma once
// The loops of fixed-point evaluation: one operator over an array of lanes, int64 words in and out. Every loop is branch-free and free of
// calls, so that the compiler vectorises it; where the compiler can, each is built twice, for any 64-bit machine and for AVX2, and the
// machine chooses. Integer results are the same either way, and the few doubles involved hold integers exactly.

#include <array>
#include <cstdint>

#include "datapath/arithmetic.h"
#include "datapath/format.h"
#include "datapath/table.h"

namespace bump {

/// The rounding rule of format.h, prepared: floor to the result's fraction, then wrap to its width.
struct RoundingRule {
  int left = 0, right = 0;          ///< one of them is 0; right <= 63
  std::int64_t mask = 0, sign = 0;  ///< bits that remain after a logical right shift, and the topmost of them if it carries a sign
  std::int64_t keep = -1;           ///< width of an unsigned result that is wider than what a right shift leaves

  std::int64_t apply(std::int64_t exact) const {
    const auto moved = static_cast<std::int64_t>((static_cast<std::uint64_t>(exact) << left) >> right);
    return (((moved & mask) ^ sign) - sign) & keep;
  }
};
RoundingRule rounding_rule(int from_fraction, const Format& to);

/// floor(word / 2^right), on words of up to 62 bits; vectorises on machines without a 64-bit arithmetic shift.
inline std::int64_t floor_shift(std::int64_t word, int right) {
  constexpr std::int64_t bias = std::int64_t{1} << 62;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(word + bias) >> right) - (bias >> right);
}

using Words = std::int64_t*;
using ConstWords = const std::int64_t*;

namespace lanes {

/// Reals to words as quantise() does.
void quantise(const double* values, const Format& to, Words words, int lanes);
/// Words to their values.
void to_double(ConstWords words, const Format& format, double* values, int lanes);

/// rule(a * 2^left_a + b * 2^left_b), and the difference.
void add(ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out, int lanes);
void subtract(ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out, int lanes);
/// The difference where the flag is set, else the sum.
void add_or_subtract(ConstWords flags, ConstWords a, int left_a, ConstWords b, int left_b, RoundingRule rule, Words out, int lanes);
void multiply(ConstWords a, ConstWords b, RoundingRule rule, Words out, int lanes);
/// `narrow`: dividend as shifted, divisor and radicand as shifted have at most narrow_bits bits.
void divide(ConstWords a, ConstWords b, DividerShape shape, bool narrow, Words out, int lanes);
void root(ConstWords a, RootShape shape, bool narrow, Words out, int lanes);
void move(ConstWords a, RoundingRule rule, Words out, int lanes);
/// rule(floor(a * 2^(left - k))); a * 2^left has at most 61 bits.
void move_by(ConstWords a, int left, ConstWords k, RoundingRule rule, Words out, int lanes);
void negate(ConstWords a, RoundingRule rule, Words out, int lanes);
void absolute(ConstWords a, RoundingRule rule, Words out, int lanes);
/// Inverts the top bit of a word of one turn.
void half_turn(ConstWords a, int width, Words out, int lanes);
/// min(max(floor(a * 2^(left - right)), low), high).
void clamp(ConstWords a, int left, int right, std::int64_t low, std::int64_t high, Words out, int lanes);
void select(ConstWords flags, ConstWords a, RoundingRule rule_a, ConstWords b, RoundingRule rule_b, Words out, int lanes);
void is_negative(ConstWords a, Words out, int lanes);
void is_beyond_quarter(ConstWords a, int width, Words out, int lanes);
void exclusive_or(ConstWords a, ConstWords b, Words out, int lanes);

/// address_of() for every lane, an array of words per index word. negative and beyond are all ones where the index was reflected, else 0.
void addresses(const Table& table, const std::array<ConstWords, 3>& index, Words address, Words negative, Words beyond, int lanes);
/// words[address], negated where (negative and odd_zero) xor (beyond and odd_quarter) is all ones.
void read(ConstWords words, ConstWords address, ConstWords negative, std::int64_t odd_zero, ConstWords beyond, std::int64_t odd_quarter,
          Words out, int lanes);

}  // namespace lanes

}  // namespace bump
