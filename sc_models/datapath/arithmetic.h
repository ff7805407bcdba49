#pragma once
// Division and square root as the restoring arrays of the hardware do them, one result bit a row, and the quick equivalents that the
// evaluator uses. The bit-serial functions are the definition; the quick ones are tested equal. What the rows cost in cycles is the
// schedule's business (schedule.h). Source: restoring division and root as in any text on computer arithmetic, e.g. Parhami, "Computer
// Arithmetic", chapters 13 and 21.

#include <cstdint>

#include "datapath/format.h"

namespace bump {

/// Bits of the word without its sign.
inline int magnitude_bits(const Format& format) {
  return format.width - (format.is_signed ? 1 : 0);
}

/// A clamp's bound as a word of the result: to nearest, and saturated even for an angle that wraps.
inline std::int64_t bound_word(double bound, Format format) {
  format.is_angle = false;
  return quantise(bound, format);
}

/// The array that divides a by b into the quotient's format.
struct DividerShape {
  int shift = 0;      ///< the dividend is |a| * 2^shift (floor when negative): this makes the quotient's fraction
  int dividend = 0;   ///< bits of the dividend, those of the quotient at least
  int magnitude = 0;  ///< quotient bits, each a row of the array; what the dividend has in front of them is the first remainder
};
DividerShape divider_shape(const Format& a, const Format& b, const Format& quotient);

/// The array that takes the root of a into the root's format.
struct RootShape {
  int shift = 0;      ///< the radicand is a * 2^shift (floor when negative)
  int rows = 0;       ///< root bits
  int magnitude = 0;  ///< root bits kept
};
RootShape root_shape(const Format& a, const Format& root);

/// word * 2^shift, floored; the result must fit.
inline std::uint64_t scaled(std::uint64_t word, int shift) {
  if (shift >= 0) return word << shift;
  return shift <= -64 ? 0 : word >> -shift;
}

/// floor(dividend / divisor) in `rows` bits, one a row; all ones where that is too large for them, and by divisor 0. rows <= 62, dividend
/// and divisor < 2^62.
std::uint64_t restoring_division(std::uint64_t dividend, std::uint64_t divisor, int rows);
/// floor(sqrt(radicand)) in `rows` bits. rows <= 31, radicand < 4^rows.
std::uint64_t restoring_root(std::uint64_t radicand, int rows);

/// The whole operator, words in and out, by the array.
std::int64_t divide_by_array(std::int64_t a, std::int64_t b, const DividerShape& shape);
std::int64_t root_by_array(std::int64_t a, const RootShape& shape);
/// The same words, quickly.
std::int64_t divide(std::int64_t a, std::int64_t b, const DividerShape& shape);
std::int64_t root(std::int64_t a, const RootShape& shape);

}  // namespace bump
