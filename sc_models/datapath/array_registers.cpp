#include "datapath/array_registers.h"

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/invariant.h"

namespace bump {

int rows_per_segment(int rows, int stages) {
  return (rows + stages) / (stages + 1);
}

std::vector<DividerEdge> divider_edges(const Format& a, const Format& b, const Format& quotient, int stages) {
  BUMP_ASSERT(stages >= 0 && !b.is_signed && (quotient.is_signed || !a.is_signed));
  const int rows = magnitude_bits(quotient), shift = divider_shape(a, b, quotient).shift, share = rows_per_segment(rows, stages);
  const int dropped = std::max(0, -shift);  // low bits of |a|
  const auto dividend_bit = [&](int row) { return rows - 1 - row - shift; };
  int remainder = std::clamp(a.width + shift - rows, 0, b.width), found = 0, row = 0;
  std::vector<DividerEdge> edges;
  for (int edge = 0; edge < stages; ++edge) {
    for (const int end = std::min(rows, row + share); row < end; ++row) {
      if (dividend_bit(row) >= a.width) continue;  // nothing of the dividend has entered yet
      remainder = std::min(remainder + 1, b.width);
      ++found;
    }
    DividerEdge kept;
    kept.sign = a.is_signed ? 1 : 0;
    kept.found = found;
    if (row < rows && dividend_bit(rows - 1) < a.width) {
      kept.divisor = b.width;
      kept.remainder = remainder;
      kept.rest = std::max(0, std::min(a.width - 1, dividend_bit(row)) - dropped + 1);
    }
    edges.push_back(kept);
  }
  return edges;
}

std::vector<RootEdge> root_edges(const Format& a, const Format& root, int stages) {
  BUMP_ASSERT(stages >= 0 && !a.is_signed);
  const RootShape shape = root_shape(a, root);
  const int share = rows_per_segment(shape.rows, stages), dropped = std::max(0, -shape.shift);
  std::vector<RootEdge> edges;
  for (int row = std::min(shape.rows, share); static_cast<int>(edges.size()) < stages; row = std::min(shape.rows, row + share)) {
    RootEdge kept;
    if (row < shape.rows) {
      kept.remainder = row > 0 ? row + 1 : 0;
      const int highest = 2 * (shape.rows - 1 - row) - shape.shift + 1;  // bit of a that the next row brings in
      kept.rest = std::max(0, std::min(a.width - 1, highest) - dropped + 1);
    }
    kept.found = row == shape.rows ? std::min(row, shape.magnitude) : row;
    edges.push_back(kept);
  }
  return edges;
}

TableEdges table_edges(const Table& table, int stages) {
  BUMP_ASSERT(stages >= 0);
  bool sign = false, beyond = false, mirrors = false;
  for (const Column& column : table.columns) {
    const bool folded = table.stored_width(column) < column.format.width;
    sign = sign || (folded && column.symmetry.odd_about_zero);
    beyond = beyond || (folded && column.symmetry.odd_about_quarter && table.folding == Folding::quarter);
    mirrors = mirrors || column.mirrors_first;
  }
  const int signs = (sign ? 1 : 0) + (beyond ? 1 : 0);
  TableEdges edges;
  edges.behind = stages > 1 ? 1 : 0;
  edges.in_front = stages - edges.behind;
  edges.address_bits = table.address_bits + table.field_bits() + signs;
  edges.word_bits = table.word_bits() + (mirrors ? table.stored_width(table.columns.front()) : 0) + signs;
  return edges;
}

}  // namespace bump
