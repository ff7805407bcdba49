#include "rtl/table_address.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// The highest `kept` bits of a word, with zeros behind where it has fewer.
std::string highest_bits(const std::string& word, int width, int kept) {
  return concatenation({bits_of(word, width - 1, std::max(0, width - kept)), copies("1'b0", kept - width)});
}

std::string plain(const std::string& word, const Format& format, int kept) {
  if (!format.is_signed) return highest_bits(word, format.width, kept);
  const int top = format.width - 1;
  return concatenation(
      {"~" + bits_of(word, top, top), bits_of(word, top - 1, std::max(0, format.width - kept)), copies("1'b0", kept - format.width)});
}

LeafText::Read read_of(int width, int kept) {
  return width > kept ? LeafText::Read::partly : LeafText::Read::whole;
}

std::string magnitude(LeafText& text, const Table& table, const std::string& index, const std::string& suffix) {
  const int top = table.index.width - 1;
  const std::string absolute = "absolute" + suffix, folded = "folded" + suffix;
  text.word(absolute, top + 1, fmt::format("{0}[{1}] ? -{0} : {0}", index, top));
  text.word(folded, top, fmt::format("{} | {}", bits_of(absolute, top - 1, 0), copies(bits_of(absolute, top, top), top)),
            read_of(top, table.address_bits));
  return highest_bits(folded, top, table.address_bits);
}

std::string quarter(LeafText& text, const Table& table, const std::string& index, const std::string& suffix) {
  const int bits = table.index.width - 2;
  if (bits == 0) return copies("1'b0", table.address_bits);
  const std::string rest = "rest" + suffix, folded = "folded" + suffix;
  text.word(rest, bits, bits_of(index, bits - 1, 0));
  text.line(fmt::format("// From the quarter turn backwards in odd quadrants; the quarter turn itself shares the last code."));
  const std::string backwards = fmt::format("-{} | {}", rest, copies(fmt::format("({} == {})", rest, verilog_word(0, bits)), bits));
  text.word(folded, bits, fmt::format("{}[{}] ? ({}) : {}", index, bits, backwards, rest), read_of(bits, table.address_bits));
  return highest_bits(folded, bits, table.address_bits);
}

/// The places of a floating index in which its leading one makes a code of its own.
struct Window {
  int lowest = 0;                  ///< place of the lowest binade; may be below the word
  int exponent_bits = 0;           ///< left to find: the window has 2^exponent_bits places
  std::vector<std::string> known;  ///< exponent bits above them, the same for every place within the word
};

Window window_of(const Table& table) {
  Window window;
  window.lowest = table.min_exponent + table.index.fraction;
  window.exponent_bits = table.exponent_bits;
  for (; window.exponent_bits > 0; --window.exponent_bits) {
    const int middle = window.lowest + (1 << (window.exponent_bits - 1));
    if (middle < 0) {
      window.known.push_back("1'b1");
      window.lowest = middle;
    } else if (middle >= table.index.width) {
      window.known.push_back("1'b0");
    } else {
      break;
    }
  }
  return window;
}

/// Places high..low of a word, zeros where it has none.
std::string places(const std::string& word, int width, int high, int low) {
  const int above = std::clamp(high - width + 1, 0, high - low + 1), below = std::clamp(-low, 0, high - low + 1);
  return concatenation({copies("1'b0", above), bits_of(word, std::min(high, width - 1), std::max(low, 0)), copies("1'b0", below)});
}

std::string floating(LeafText& text, const Table& table, const std::string& index, const std::string& suffix) {
  const int mantissa_bits = table.address_bits - table.exponent_bits, width = table.index.width;
  const int highest = table.min_exponent + table.index.fraction + (1 << table.exponent_bits) - 1;
  Window window = window_of(table);
  text.remark(fmt::format("Leading-one detector: places {} to {} of the index make {} exponent bits.",
                          table.min_exponent + table.index.fraction, highest, table.exponent_bits));
  std::vector<std::string> code = window.known;
  int bits = (1 << window.exponent_bits) + mantissa_bits;
  std::string found = "places" + suffix;
  text.word(found, bits, places(index, width, window.lowest + (1 << window.exponent_bits) - 1, window.lowest - mantissa_bits));
  for (int level = window.exponent_bits - 1; level >= 0; --level) {
    const int half = 1 << level;
    const std::string exponent = fmt::format("exponent{}{}", level, suffix), next = fmt::format("window{}{}", level, suffix);
    text.bit(exponent, "|" + bits_of(found, bits - 1, bits - half));
    text.word(next, bits - half, fmt::format("{} ? {} : {}", exponent, bits_of(found, bits - 1, half), bits_of(found, bits - half - 1, 0)));
    code.push_back(exponent);
    found = next;
    bits -= half;
  }
  code.push_back(bits_of(found, mantissa_bits - 1, 0));
  // Below the lowest binade the leading place stays empty.
  std::string address =
      fmt::format("{} & {}", concatenation(code), copies(bits_of(found, mantissa_bits, mantissa_bits), table.address_bits));
  const std::string above = bits_of(index, width - 1, std::max(0, highest + 1));
  if (above.empty()) return address;
  text.bit("above" + suffix, "|" + above);
  return fmt::format("({}) | {}", address, copies("above" + suffix, table.address_bits));
}

}  // namespace

std::string address_expression(LeafText& text, const Table& table, const std::vector<std::string>& index, const std::string& suffix) {
  BUMP_ASSERT(static_cast<int>(index.size()) == table.index_words());
  std::string first;
  switch (table.folding) {
    case Folding::none:
      first = plain(index[0], table.index, table.address_bits);
      break;
    case Folding::magnitude:
      first = magnitude(text, table, index[0], suffix);
      break;
    case Folding::quarter:
      first = quarter(text, table, index[0], suffix);
      break;
    case Folding::floating:
      first = floating(text, table, index[0], suffix);
      break;
  }
  if (!table.is_map()) return first;
  text.word("field" + suffix, table.address_bits, first);
  std::vector<std::string> parts{"field" + suffix};
  for (std::size_t i = 0; i < table.fields.size(); ++i)
    parts.push_back(plain(index[i + 1], table.fields[i].index, table.fields[i].address_bits));
  return concatenation(parts);
}

bool is_partly_read(const Table& table, int index_word) {
  if (index_word > 0) {
    const MapField& field = table.fields[static_cast<std::size_t>(index_word) - 1];
    return field.index.width > field.address_bits;
  }
  switch (table.folding) {
    case Folding::none:
      return table.index.width > table.address_bits;
    case Folding::magnitude:
      return false;  // the negation reads all of it
    case Folding::quarter:
      return true;  // whether the top bit is read depends on the columns' signs
    case Folding::floating:
      return table.min_exponent + table.index.fraction > table.address_bits - table.exponent_bits;
  }
  return false;
}

}  // namespace bump
