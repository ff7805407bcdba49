#pragma once
// A look-up table (ROM) of a datapath: its function, how an index becomes an address, and the word of every column.
// Several output columns read by one index are one table: this is how the paper reaches six tables a vector.
//
// Address rules, bit by bit, for an index word `i` of format F (width w) and a ROM of 2^k words:
//   none        unsigned: a = i >> (w-k). Signed: a = (i + 2^(w-1)) >> (w-k).
//   magnitude   a = min(|i|, 2^(w-1)-1) >> (w-1-k); columns that are odd change sign with i.
//   quarter     F is a full turn. q = top two bits, r = the rest; m = q odd ? 2^(w-2) - r : r, saturated to 2^(w-2)-1;
//               a = m >> (w-2-k); the sign of each column follows from its symmetries and q.
//   floating    i is unsigned; a leading-one detector makes a short floating-point code, exponent in e bits and mantissa in k-e bits:
//               for v = i * 2^-fraction, exponent = floor(log2 v) clamped to [min_exponent, min_exponent + 2^e - 1]; v below the lowest
//               binade reads address 0, above the highest reads the last address; mantissa bits follow the leading one, truncated.
// When an index has fewer bits than the ROM has address bits, the missing low address bits are zero. A word holds the function at the
// centre of the codes that share it (at the code itself when only one does), rounded to nearest and saturated to the column's format.
//
// A map has up to three index words: each makes a field of the address by the rules above, the first word the highest field. Words behind
// the first follow `none`; the first may be folded, which gives the odd columns their sign.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "datapath/format.h"
#include "datapath/real_block.h"
#include "datapath/real_function.h"

namespace bump {

enum class Folding { none, magnitude, quarter, floating };

/// How a column behaves when the index is reflected about 0 and about a quarter turn. `odd` changes the sign.
struct Symmetry {
  bool odd_about_zero = false;
  bool odd_about_quarter = false;
};

struct Column {
  std::string name;       ///< e.g. "sin"
  RealFunction function;  ///< value for an unfolded index value (turns for angles); total: finite for every index
  std::function<double(const double*)> map_function;  ///< the same for a map: of all its index values, in order
  Format format{};                                    ///< of the value read, sign included
  Symmetry symmetry{};                                ///< used by `magnitude` and `quarter`
  bool mirrors_first = false;  ///< read from the first column's words at the complemented address: costs a port, no bits
};

/// An index word of a map behind the first.
struct MapField {
  Format index{};
  int address_bits = 0;  ///< its share of the address
};

struct Table {
  std::string name;     ///< unique within the scheme, e.g. "SC"; also the file name of its ROM image
  std::string formula;  ///< one line, e.g. "sin x, cos x; x in turns"
  Format index{};       ///< format of the index word
  Folding folding = Folding::none;
  int address_bits = 8;          ///< 2^address_bits words, times those of the fields behind
  int min_exponent = 0;          ///< `floating` only
  int exponent_bits = 0;         ///< `floating` only
  bool per_material = false;     ///< contents follow the material: one copy per material in the scene
  std::vector<MapField> fields;  ///< index words behind the first, at most two; any makes the table a map
  std::vector<Column> columns;
  /// What the columns' functions compute, for a block of the double evaluation: the same functions to two units in the last place, in
  /// vector code (real_tables.h). Optional; words are never made by it.
  BlockFunction block;

  /// Table 1 of Lee 2007 calls tables with more than one index maps.
  bool is_map() const { return !fields.empty(); }
  int index_words() const { return 1 + static_cast<int>(fields.size()); }
  /// Address bits of the fields behind the first.
  int field_bits() const;
  std::int64_t entries() const { return std::int64_t{1} << (address_bits + field_bits()); }
  /// Value of a column at index values, one per index word.
  double value(const Column& column, const double* at) const { return is_map() ? column.map_function(at) : column.function(*at); }
  /// Bits of one stored word: the stored widths of the columns that have words of their own, side by side.
  int word_bits() const;
  /// Stored bits: entries() words.
  std::int64_t bits() const { return entries() * word_bits(); }
  /// Bits of one stored word of `column`: its format's width, less the sign bit where folding supplies the sign.
  int stored_width(const Column& column) const;
};

using TablePtr = std::shared_ptr<const Table>;

/// The address that an index word reads, and the sign that folding gives each column.
struct TableAddress {
  std::int64_t address = 0;
  bool negative_index = false;  ///< reflected about zero
  bool beyond_quarter = false;  ///< reflected about a quarter turn
};
/// A word for each index word that the table has.
using IndexWords = std::array<std::int64_t, 3>;
TableAddress address_of(const Table& table, const IndexWords& index);
/// For a table of one index word.
TableAddress address_of(const Table& table, std::int64_t index);

/// ROM words (signed integers in the column's stored format), one vector per column; a mirrored column repeats the first reversed.
struct TableContents {
  std::vector<std::vector<std::int64_t>> words;
};
TableContents tabulate(const Table& table);

/// The word read by `index` from `column`, sign applied, in the column's format.
std::int64_t look_up(const Table& table, const TableContents& contents, std::size_t column, const IndexWords& index);
std::int64_t look_up(const Table& table, const TableContents& contents, std::size_t column, std::int64_t index);

}  // namespace bump
