#include "testbench/results/text_table.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::vector<std::size_t> widths_of(const TextTable& table) {
  std::vector<std::size_t> widths(table.header.size(), 0);
  const auto measure = [&](const std::vector<std::string>& cells) {
    BUMP_ASSERT(cells.size() == widths.size());
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  };
  measure(table.header);
  for (const auto& row : table.rows) measure(row);
  return widths;
}

std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
  return text;
}

}  // namespace

std::string aligned(const TextTable& table, std::size_t indent) {
  const std::vector<std::size_t> widths = widths_of(table);
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text(indent, ' ');
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - cells[i].size(), ' ');
      text += (i == 0 ? "" : "  ") + (i < table.left_columns ? cells[i] + padding : padding + cells[i]);
    }
    return without_trailing_blanks(text) + "\n";
  };
  std::size_t whole = 0;
  for (const std::size_t width : widths) whole += width + 2;
  std::string text = line(table.header) + std::string(indent, ' ') + std::string(whole < 2 ? 0 : whole - 2, '-') + "\n";
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string markdown(const TextTable& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + escaped(cell) + (cell.empty() ? "|" : " |");
    return text + "\n";
  };
  std::string text = line(table.header) + "|";
  for (std::size_t i = 0; i < table.header.size(); ++i) text += i < table.left_columns ? "--|" : "--:|";
  text += "\n";
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += fields[i];
      continue;
    }
    line += '"';
    for (const char c : fields[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

std::string folded(const std::string& text, std::size_t width, const std::string& first) {
  const std::string rest(first.size(), ' ');
  std::string result, line = first;
  bool begins = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    if (!begins && line.size() + 1 + word.size() > width) {
      result += line + "\n";
      line = rest;
      begins = true;
    }
    line += (begins ? "" : " ") + word;
    begins = false;
  }
  return result + line + "\n";
}

}  // namespace bump
