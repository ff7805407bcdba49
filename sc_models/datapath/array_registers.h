#pragma once
// The registers inside dividers, square roots and tables of several cycles: what is kept at each of the `stages` clock edges that cut the
// operator into stages + 1 segments. Rows of an array are dealt to the segments evenly, the first ones full; a word is kept only as long as
// a later row reads it. What is priced (price_registers.h) and what is emitted (rtl/divider_module.h and its like) follow this one plan.

#include <cstdint>
#include <vector>

#include "datapath/format.h"
#include "datapath/table.h"

namespace bump {

/// Rows of an array in each of the stages + 1 segments; the last ones may have fewer.
int rows_per_segment(int rows, int stages);

/// What a divider keeps at an edge, in bits. The quotient has one row for each bit of its magnitude.
struct DividerEdge {
  int sign = 0;       ///< of a
  int too_large = 1;  ///< the quotient does not fit
  int divisor = 0;
  int remainder = 0;
  int rest = 0;   ///< bits of |a| that rows behind the edge bring in
  int found = 0;  ///< quotient bits

  int bits() const { return sign + too_large + divisor + remainder + rest + found; }
};

std::vector<DividerEdge> divider_edges(const Format& a, const Format& b, const Format& quotient, int stages);

/// What a square root keeps at an edge, in bits.
struct RootEdge {
  int remainder = 0;
  int rest = 0;   ///< bits of a that rows behind the edge bring in
  int found = 0;  ///< root bits, with those that the format drops as long as rows need them

  int bits() const { return remainder + rest + found; }
};
std::vector<RootEdge> root_edges(const Format& a, const Format& root, int stages);

/// A read of a table: with several edges the last is behind the ROM, the others in front of it.
struct TableEdges {
  int in_front = 0;      ///< edges that keep the address
  int behind = 0;        ///< edges that keep the word
  int address_bits = 0;  ///< kept at an edge in front, with the signs that the columns get back
  int word_bits = 0;     ///< kept at an edge behind, with those signs

  std::int64_t bits() const { return std::int64_t{in_front} * address_bits + std::int64_t{behind} * word_bits; }
};
TableEdges table_edges(const Table& table, int stages);

}  // namespace bump
