#pragma once
// Conversions between integers and doubles, and rounding, by the bits of the double alone: no branch, no library call, so that loops over
// lanes vectorise on any 64-bit machine. They lean on 2^52, above which a double holds integers only. Used by the evaluators; the scalar
// rules of format.h use the same functions, so both agree by construction. Timing: none, this is host arithmetic.

#include <cmath>
#include <cstdint>
#include <cstring>

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

/// value * scale to the nearest integer in [lowest, highest], ties upwards; NaN becomes 0. |lowest|, |highest| < 2^51.
inline std::int64_t quantise_narrow(double value, double scale, double lowest, double highest) {
  const double scaled = value * scale;
  const double number = scaled == scaled ? scaled : 0.0;
  const double below = number < highest ? number : highest;
  return narrow_of_double(round_half_up(below > lowest ? below : lowest));
}

}  // namespace bump
