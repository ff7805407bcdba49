#pragma once
// Tables as aligned text, Markdown and CSV, and running text folded to a width. Nothing about hardware.

#include <string>
#include <vector>

namespace bump {

struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as the header
  std::size_t left_columns = 1;                ///< this many from the left are aligned left, the others right
};

/// Columns as wide as their widest cell, two blanks between, each line indented; a rule of '-' below the header. Widths count bytes: ASCII
/// only.
std::string aligned(const TextTable& table, std::size_t indent = 2);
/// A GitHub table; '|' in cells is escaped, empty cells stay empty.
std::string markdown(const TextTable& table);

/// One line with line break (RFC 4180: quotes around fields that need them, doubled inside).
std::string csv_line(const std::vector<std::string>& fields);

/// Breaks at blanks so that no line is longer than `width`, unless a word is. `first` stands before the first line, as many blanks before
/// the others.
std::string folded(const std::string& text, std::size_t width, const std::string& first = "");

}  // namespace bump
