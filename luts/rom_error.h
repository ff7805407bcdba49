#pragma once
// How far a ROM is from the function it holds: the largest difference between what an index reads and the function of that very index, so
// it covers quantisation of the words, coarse addresses, folding, mirrored columns and saturation alike.

#include <cstdint>
#include <vector>

#include "datapath/table.h"

namespace bump {

struct ColumnError {
  double largest = 0;             ///< over all codes checked; infinite where the function is
  double largest_in_range = 0;    ///< over the codes whose function value the column's format can hold
  std::int64_t out_of_range = 0;  ///< codes checked whose function value the format cannot hold (the word is saturated)
};

struct RomError {
  std::int64_t codes = 0;  ///< index codes checked
  bool all_codes = true;   ///< false for wide indices: evenly spaced codes of every address then
  std::vector<ColumnError> columns;
};

/// Checks every code of indices up to 20 bits; beyond that, and of maps, up to 17 codes of every address of the first index word, with up
/// to three codes of every address of the words behind. Columns that are full-turn angles differ modulo one turn.
RomError rom_error(const Table& table, const TableContents& contents);

}  // namespace bump
