#pragma once
// What of a ROM's contents decides how many gates it takes when it is made of gates: not its bits, but how often they change from one
// word to the next. A bit that is the same over long runs of addresses is a small function of the address, one that changes with every
// word is a large one. The exception is a straight line, which is the address times a constant. No time. Source: synthesis of this
// project's ROM images, whose areas follow the changes within a fifth and the stored bits only within a factor of two.

#include <vector>

#include "datapath/table.h"

namespace bump {

struct RomContents {
  /// For each column, over all pairs of neighbouring addresses: stored bits that differ. 0 for a column without words of its own and
  /// for tables of columns without a fixed-point format.
  std::vector<double> changes;
  /// Whether the words of every column lie on a line through its ends, within one unit of the last place.
  bool is_line = false;
};

RomContents contents_of(const Table& table);

}  // namespace bump
