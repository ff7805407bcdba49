#include "luts/rom_image.h"

#include <vector>

namespace bump {

namespace {

/// Most significant bit first.
std::vector<bool> word_bits_at(const Table& table, const TableContents& contents, std::size_t address) {
  std::vector<bool> bits;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].mirrors_first) continue;
    const auto word = static_cast<std::uint64_t>(contents.words[i][address]);
    for (int bit = table.stored_width(table.columns[i]) - 1; bit >= 0; --bit) bits.push_back(((word >> bit) & 1) != 0);
  }
  return bits;
}

}  // namespace

std::string rom_image(const Table& table, const TableContents& contents) {
  std::string text;
  const auto padding = static_cast<std::size_t>((4 - table.word_bits() % 4) % 4);
  for (std::size_t address = 0; address < static_cast<std::size_t>(table.entries()); ++address) {
    std::vector<bool> bits(padding, false);
    const std::vector<bool> word = word_bits_at(table, contents, address);
    bits.insert(bits.end(), word.begin(), word.end());
    for (std::size_t i = 0; i < bits.size(); i += 4)
      text += "0123456789abcdef"[(bits[i] ? 8 : 0) + (bits[i + 1] ? 4 : 0) + (bits[i + 2] ? 2 : 0) + (bits[i + 3] ? 1 : 0)];
    text += '\n';
  }
  return text;
}

}  // namespace bump
