#pragma once
// ROMs of a division by logarithms: -log2 |tan| and -log2 |sin| of angles, and the arc tangent of 2^-x. Timing: that of a table read.

#include <string>

#include "datapath/table.h"

namespace bump::n2l {

/// -log2 |tan| of a full-turn angle, folded to a quarter turn; signed, within +-2^4.
TablePtr log_tangent_table(const std::string& name, const Format& index, int table_bits, int log_bits);
/// -log2 |sin| likewise; unsigned, below 2^4.
TablePtr log_sine_table(const std::string& name, const Format& index, int table_bits, int log_bits);
/// atan(2^-x) in turns, x >= 0, by a floating index of 16 binades: an eighth of a turn at 0, and the smaller, the less x counts.
TablePtr arc_tangent_of_power_table(const std::string& name, const Format& index, int address_bits, const Format& angle_format);

}  // namespace bump::n2l
