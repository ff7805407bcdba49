#pragma once
// ROMs of inverse functions: arc sine, arc cosine, arc tangent, reciprocal; and the arc tangent of two arguments that the last two make
// with one multiplier. Angles are magnitudes within a quarter turn; the quadrant follows from signs, which is wiring, as in Lee 2007, Fig.
// 8 (no adder counts for it). Source: Lee 2007, sections 4.1 and 5.1 (arc sine, arc tangent and reciprocal tables); shapes are a
// reconstruction. Total: every index, 0 included, has a finite value.

#include <string>

#include "datapath/netlist.h"

namespace bump {

/// asin(x), odd, folded about 0: column "angle" in `angle_format` (signed, within a quarter turn).
TablePtr arc_sine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format);
/// acos(|x|), folded about 0: column "angle" in `angle_format` (unsigned, within a quarter turn).
TablePtr arc_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format);
/// atan(x), x >= 0. A tangent is unbounded, so its index is a short floating-point code of 16 binades about 1: below them the angle is
/// under a quarter of a degree, above them within a quarter of a degree of 90.
TablePtr arc_tangent_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format);
/// 1/x for 2^-8 <= x < 1 by a floating index of 3 exponent bits; smaller x reads 2^8 less half a step. `word` holds 8 integer bits.
TablePtr reciprocal_table(const std::string& name, const Format& index, int address_bits, const Format& word);

/// acos(x) over a half turn: 1 table, and sign logic for negative x. `angle_format` is a full turn.
Wire arc_cosine(Netlist& netlist, const std::string& name, Wire x, const TablePtr& table, const Format& angle_format,
                const std::string& equation = "");

/// What one arc tangent of two arguments is built of.
struct AzimuthFormats {
  Format magnitude;      ///< unsigned, one integer bit: |y|
  Format tangent;        ///< unsigned, nine integer bits: |y/x|
  Format angle;          ///< turns: the result
  TablePtr reciprocal;   ///< index: unsigned without integer bits
  TablePtr arc_tangent;  ///< index: `tangent`
};
/// For components with up to `fraction` bits after the point and tables of 2^address_bits words, all called alike in every unit of a
/// scheme: "RECIP" with words of word_bits + 4 bits and "ATAN" with words of word_bits bits.
AzimuthFormats azimuth_formats(int fraction, int address_bits, int word_bits, const Format& angle_format);

/// The angle of (x, y) over the full turn: 1 multiplier, 2 tables. The angle of (0, 0) is 0.
Wire azimuth(Netlist& netlist, const std::string& name, Wire y, Wire x, const AzimuthFormats& formats, const std::string& equation = "");

}  // namespace bump
