#pragma once
// ROMs for bringing N' to the object's polar angles: sines and cosines whose two columns have widths and factors of their own, and an arc
// cosine that is as good at the poles as at the equator. cos theta near 1 says little about theta, so the cosine column takes more bits,
// and the arc cosine is indexed by 1 - |cos theta| as a short floating-point number: theta then errs relatively. This project's. Timing:
// that of a table read.

#include <string>

#include "datapath/netlist.h"

namespace bump {

/// A column: factor * sin or cos, `word_bits` stored bits, the sign apart.
struct ScaledColumn {
  int word_bits = 12;
  double factor = 1;  ///< 0 < factor <= 1
};

/// Both of a full-turn angle, folded to a quarter turn.
TablePtr scaled_sine_cosine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& sine,
                                  const ScaledColumn& cosine);
/// One alone.
TablePtr scaled_sine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& sine);
TablePtr scaled_cosine_table(const std::string& name, const Format& index, int table_bits, const ScaledColumn& cosine);

/// acos(1 - x) in turns, 0 <= x <= 1, by a floating index of 16 binades.
TablePtr complement_arc_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format);

/// acos(x) over a half turn in `angle_format`, a full turn: 1 adder, 1 table, and sign logic for negative x.
Wire arc_cosine_of_complement(Netlist& netlist, const std::string& name, Wire x, const TablePtr& table, const Format& angle_format);

/// Bits of a cosine beyond those of a sine: near a pole theta follows from what is missing to 1.
constexpr int pole_bits = 6;
/// The same of a half sum of cosines of word_bits + pole_bits bits, with a ROM "ACOS" of 2^address_bits words.
Wire polar_arc_cosine(Netlist& netlist, const std::string& name, Wire half_sum, int address_bits, int word_bits,
                      const Format& angle_format);

/// Half a turn less the angle where `flag` is set: sign logic.
Wire opposite_if(Netlist& netlist, const std::string& name, Wire flag, Wire angle);

}  // namespace bump
