#pragma once
// Sine and cosine ROMs folded to a quarter turn, the tables every polar scheme reads. The sign of a folded column costs no bit, so a word
// of w bits gives a value of w + 1 bits with its sign. Source: Lee 2007, section 5.1 (sin & cos LUTs); widths schemes' own.

#include <string>

#include "datapath/table.h"

namespace bump {

/// sin and cos of a full-turn angle, two columns of `word_bits` stored bits read by one index: one table in the sense of Lee 2007, Table 1.
TablePtr sine_cosine_table(const std::string& name, const Format& index, int address_bits, int word_bits);
/// sin or cos alone.
TablePtr sine_table(const std::string& name, const Format& index, int address_bits, int word_bits);
TablePtr cosine_table(const std::string& name, const Format& index, int address_bits, int word_bits);
/// cos^2 of half the angle, (1 + cos)/2, of `word_bits` bits in [0, 1), over a half turn folded about 0.
TablePtr cosine_half_squared_table(const std::string& name, const Format& index, int address_bits, int word_bits);
/// (1 - cos)/2, of `word_bits` bits in [0, 1), over a half turn folded about 0.
TablePtr haversine_table(const std::string& name, const Format& index, int address_bits, int word_bits);
/// What is read from them: a sign and `word_bits` fraction bits.
Format sine_format(int word_bits);

}  // namespace bump
