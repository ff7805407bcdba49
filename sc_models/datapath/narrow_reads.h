#pragma once
// ROM reads on 32-bit lanes: one pass turns an index into an address, reads a column, or two that share a packed word, and applies the
// signs of folding. Address rules as in table.h. Tables with one index word only; maps take the passes of lane_kernels.h.

#include <cstdint>
#include <vector>

#include "datapath/narrow_kernels.h"
#include "datapath/table.h"

namespace bump {

/// The columns that one pass reads, prepared.
struct NarrowRead {
  struct Column {
    std::int32_t odd_zero = 0, odd_quarter = 0;  ///< all ones where reflection changes the sign
    int up = 0, down = 0;                        ///< moves the column's share of a packed word into place
    std::int32_t keep = -1;
  };

  Folding folding = Folding::none;
  int index_bits = 0;
  std::int32_t origin = 0;   ///< none: what makes the index unsigned
  std::int32_t highest = 0;  ///< magnitude, quarter: largest folded index
  int left = 0, right = 0;   ///< folded index to address
  int mantissa_bits = 0;     ///< floating
  std::int32_t lowest_code = 0, last = 0;
  bool is_pair = false;
  Column first, second;
  std::vector<std::int32_t> words;  ///< by address
};

/// Whether read() below can do it: one index word that fits a narrow lane, and columns whose words do.
bool has_narrow_reads(const Table& table);
/// Whether columns `first` and `first + 1` fit one packed word.
bool packs(const Table& table, std::size_t first);
/// The pass for column `first`, and the next one if `pair`.
NarrowRead narrow_read(const Table& table, const TableContents& contents, std::size_t first, bool pair);

namespace narrow {

/// `second` is null unless the read is a pair.
void read(const NarrowRead& r, ConstNarrowWords index, NarrowWords first, NarrowWords second, int lanes);

}  // namespace narrow

}  // namespace bump
