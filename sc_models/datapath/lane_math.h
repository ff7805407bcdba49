#pragma once
// Conversions between integers and doubles, and rounding, by the bits of the double alone: no branch, no library call, so that loops over
// lanes vectorise on any 64-bit machine. They lean on 2^52, above which a double holds integers only. Used by the evaluators; the scalar
// rules of format.h use the same functions, so both agree by construction. Timing: none, this is host arithmetic.

#include <cmath>
#include <cstdint>
#include <cstring>

/// A function that belongs into the loops of others: a call left standing would keep them from vectorising.
#define BUMP_LANE_FUNCTION inline __attribute__((always_inline))

namespace bump {

/// Words of at most this many bits take the vectorised paths; wider ones are exact too, lane by lane.
constexpr int narrow_bits = 50;

constexpr double two_to_52 = 4503599627370496.0;
constexpr std::int64_t bits_of_two_to_52 = 0x4330000000000000;
constexpr double one_and_a_half_times_two_to_52 = 6755399441055744.0;
constexpr std::int64_t bits_of_one_and_a_half_times_two_to_52 = 0x4338000000000000;

inline double double_from_bits(std::int64_t bits) {
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

inline std::int64_t bits_from_double(double value) {
  std::int64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// The leading 26 bits of a value: the product of two such halves is exact. What was cut off is exact too, as the difference.
inline double top_half(double value) {
  return double_from_bits(bits_from_double(value) & ~std::int64_t{0x7ffffff});
}

/// a where the mask is all ones, b where it is zero. By bits: several conditions on one flag would be compiled as a path for each of its
/// values, and a vector would take both.
BUMP_LANE_FUNCTION double choose(std::int64_t mask, double a, double b) {
  return double_from_bits((bits_from_double(a) & mask) | (bits_from_double(b) & ~mask));
}

/// c[first] + c[first + 1] s + ..., `count` terms; powers are s, s^2, s^4, s^8.
template <std::size_t first, std::size_t count, std::size_t n>
BUMP_LANE_FUNCTION double terms(const double (&c)[n], const double (&powers)[4]) {
  if constexpr (count == 1) {
    return c[first];
  } else {
    constexpr std::size_t level = count > 8 ? 3 : count > 4 ? 2 : count > 2 ? 1 : 0, half = std::size_t{1} << level;
    return terms<first, half>(c, powers) + powers[level] * terms<first + half, count - half>(c, powers);
  }
}

/// c[0] + c[1] s + c[2] s^2 + ..., at most 17 terms. By halves (Estrin), as a chain of sums, each waiting for the one before, takes twice
/// as long; but for the first sum, whose error counts.
template <std::size_t n>
BUMP_LANE_FUNCTION double polynomial(const double (&c)[n], double s) {
  static_assert(n <= 17);
  const double s2 = s * s, s4 = s2 * s2;
  return c[0] + s * terms<1, n - 1>(c, {s, s2, s4, s4 * s4});
}

/// Exact for |word| < 2^51.
inline double double_of_narrow(std::int64_t word) {
  return double_from_bits(word + bits_of_one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
}

/// Exact for integers with |value| < 2^51.
inline std::int64_t narrow_of_double(double value) {
  return bits_from_double(value + one_and_a_half_times_two_to_52) - bits_of_one_and_a_half_times_two_to_52;
}

/// Nearest integer, ties upwards; |value| < 2^51. The sum rounds ties to even; those that went down are put right.
inline double round_half_up(double value) {
  const double even = (value + one_and_a_half_times_two_to_52) - one_and_a_half_times_two_to_52;
  return value - even == 0.5 ? even + 1.0 : even;
}

/// value modulo one turn in [-0.5, 0.5), exact for every finite value; infinities become NaN.
inline double to_half_open_turn(double value) {
  const double magnitude = std::fabs(value);
  const double whole = magnitude < two_to_52 ? (magnitude + two_to_52) - two_to_52 : magnitude;
  const double rest = value - std::copysign(whole, value);
  return rest >= 0.5 ? rest - 1.0 : rest;
}

/// The same for values in [-1, 1], as sums of two wrapped values are; NaN stays.
inline double once_to_half_open_turn(double value) {
  const double down = value >= 0.5 ? -1.0 : 0.0, up = value < -0.5 ? 1.0 : 0.0;
  return value + (down + up);
}

/// value * scale to the nearest integer in [lowest, highest], ties upwards; NaN becomes 0. |lowest|, |highest| < 2^51.
inline std::int64_t quantise_narrow(double value, double scale, double lowest, double highest) {
  const double scaled = value * scale;
  const double number = scaled == scaled ? scaled : 0.0;
  const double below = number < highest ? number : highest;
  return narrow_of_double(round_half_up(below > lowest ? below : lowest));
}

}  // namespace bump
