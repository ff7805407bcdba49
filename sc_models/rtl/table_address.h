#pragma once
// The logic in front of a ROM as Verilog: index words become an address by the rules of table.h. Plain words are shifted, signed ones with
// their top bit inverted; magnitudes and quarter waves are folded by one conditional negation, with saturation; a floating index goes
// through a leading-one detector, a tree that halves its window of places at each level and so normalises the mantissa on the way. Timing:
// combinational. Leaves out: the signs of odd columns (table_module.h).

#include <string>
#include <vector>

#include "datapath/table.h"
#include "rtl/leaf_text.h"

namespace bump {

/// Declares what is needed of the words `index` (one per index word of the table) and returns the expression of the address,
/// address_bits + field_bits() wide. `suffix` ends the names of all that is declared, e.g. "_0".
std::string address_expression(LeafText& text, const Table& table, const std::vector<std::string>& index, const std::string& suffix);

/// Whether the address and the column signs leave bits of an index word unread. Word 0 is the first.
bool is_partly_read(const Table& table, int index_word);

}  // namespace bump
