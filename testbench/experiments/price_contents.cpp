#include "testbench/experiments/price_contents.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>

namespace bump {

namespace {

double bit_changes(const std::vector<std::int64_t>& words, int width) {
  const std::uint64_t stored = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  std::size_t count = 0;
  for (std::size_t at = 1; at < words.size(); ++at) {
    const auto now = static_cast<std::uint64_t>(words[at]), before = static_cast<std::uint64_t>(words[at - 1]);
    count += std::bitset<64>((now ^ before) & stored).count();
  }
  return static_cast<double>(count);
}

/// Two words, or words that are all the same, are no evidence of a line.
bool lie_on_line(const std::vector<std::int64_t>& words) {
  if (words.size() < 8 || words.front() == words.back()) return false;
  const auto first = static_cast<double>(words.front());
  const double slope = (static_cast<double>(words.back()) - first) / static_cast<double>(words.size() - 1);
  for (std::size_t at = 0; at < words.size(); ++at)
    if (std::abs(static_cast<double>(words[at]) - (first + slope * static_cast<double>(at))) > 1) return false;
  return true;
}

}  // namespace

RomContents contents_of(const Table& table) {
  RomContents result;
  result.changes.assign(table.columns.size(), 0);
  if (std::any_of(table.columns.begin(), table.columns.end(), [](const Column& column) { return column.format.is_real; })) return result;
  const TableContents contents = tabulate(table);
  result.is_line = !table.is_map();
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].mirrors_first) continue;
    result.changes[i] = bit_changes(contents.words[i], table.stored_width(table.columns[i]));
    result.is_line = result.is_line && lie_on_line(contents.words[i]);
  }
  return result;
}

}  // namespace bump
