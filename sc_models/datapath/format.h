#pragma once
// The numeric format on every edge of a netlist. Fixed point is `raw * 2^-fraction` in `width` bits; an angle is fixed point
// in turns (1.0 = 360 degrees), and an angle whose word is exactly one turn (width == fraction, signed) wraps for free.
//
// One rounding rule for all arithmetic: the exact result is shifted right (towards minus infinity) to the result's fraction bits and
// wrapped to its width. Rounding to nearest happens only where a real number enters: inputs, constants and table contents.

#include <cstdint>
#include <string>

namespace bump {

struct Format {
  int width = 0;           ///< bits of the word, 1..62; 0 only for `real`
  int fraction = 0;        ///< weight of the last bit is 2^-fraction
  bool is_signed = false;  ///< two's complement
  bool is_angle = false;   ///< the value is in turns
  bool is_real = false;    ///< floating point: vertex programs and interpolators, never a datapath that becomes hardware

  /// A signed word of exactly one turn: [-0.5, 0.5) turns.
  bool wraps() const { return is_angle && is_signed && width == fraction; }

  double step() const;     ///< value of one unit in the last place
  double lowest() const;   ///< smallest value that the word holds
  double highest() const;  ///< largest value that the word holds
};

bool operator==(const Format& a, const Format& b);
inline bool operator!=(const Format& a, const Format& b) { return !(a == b); }

Format sfixed(int width, int fraction);        ///< signed fixed point
Format ufixed(int width, int fraction);        ///< unsigned fixed point
Format turns(int bits);                        ///< an angle word of one full turn in `bits` bits
Format angle(int width, int fraction);         ///< a signed part of a turn, no wrap unless width == fraction
Format uangle(int width, int fraction);        ///< an unsigned part of a turn
Format flag();                                 ///< one bit
Format real();                                 ///< floating point

std::string to_string(const Format& format);   ///< "s12.10", "u8.8", "turn10", "angle s10.12", "flag", "real"

/// Floor of raw * 2^-(from_fraction - to_fraction), then wrapped to the format's width: the one rule of arithmetic.
std::int64_t truncate(std::int64_t raw, int from_fraction, const Format& to);
/// Keeps the low `width` bits, sign-extended if signed.
std::int64_t wrap(std::int64_t raw, const Format& to);
/// Nearest word (halves up). Words that wrap wrap; all others saturate. NaN becomes 0.
std::int64_t quantise(double value, const Format& to);
/// The exact value of a word.
double to_double(std::int64_t raw, const Format& format);
/// For double evaluation: an angle word of one turn brought to [-0.5, 0.5); every other value unchanged.
double wrap_turns(double value, const Format& format);

}  // namespace bump
