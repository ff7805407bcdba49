#pragma once
// The ROM image of a table as text that Verilog's $readmemh takes: one word a line in lower-case hexadecimal, address 0 first, no comments.
// A word is the stored bits of the columns side by side, the first column in the highest bits, two's complement; a mirrored column has no
// bits of its own. The same words as tabulate() gives to the evaluator.

#include <string>

#include "datapath/table.h"

namespace bump {

/// ceil(word_bits / 4) digits and a line feed for every address.
std::string rom_image(const Table& table, const TableContents& contents);

}  // namespace bump
