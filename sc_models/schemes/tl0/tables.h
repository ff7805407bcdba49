#pragma once
// ROMs of the law of haversines in logarithms: -log2 |cos| and -log2 hav of angles, hav x = (1 - cos x)/2. Timing: that of a table read.

#include <string>

#include "datapath/table.h"

namespace bump::tl0 {

/// -log2 |cos| of a full-turn angle, folded to a quarter turn, in `word`, unsigned.
TablePtr log_cosine_table(const std::string& name, const Format& index, int address_bits, const Format& word);
/// -log2 hav of a full-turn angle, folded about 0 to half a turn, in `word`, unsigned.
TablePtr log_haversine_table(const std::string& name, const Format& index, int address_bits, const Format& word);

}  // namespace bump::tl0
