#include "testbench/experiments/document.h"

#include <algorithm>
#include <sstream>

#include "datapath/invariant.h"

namespace bump {

namespace {

std::string padded(const std::string& cell, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, cell.size()), ' ');
  return left ? cell + blanks : blanks + cell;
}

}  // namespace

void Document::gap() {
  if (!text_.empty()) text_ += '\n';
  in_list_ = false;
}

void Document::heading(int level, const std::string& text) {
  gap();
  if (markdown_) {
    text_ += std::string(static_cast<std::size_t>(level), '#') + " " + text + "\n";
    return;
  }
  text_ += text + "\n";
  if (level <= 2) text_ += std::string(level == 1 ? columns : text.size(), level == 1 ? '=' : '-') + "\n";
}

void Document::wrapped(const std::string& text, const std::string& first, const std::string& others) {
  if (markdown_) {
    text_ += first + text + "\n";
    return;
  }
  std::istringstream words(text);
  std::string line = first, word;
  bool begun = false;
  while (words >> word) {
    if (begun && line.size() + 1 + word.size() > columns) {
      text_ += line + "\n";
      line = others;
      begun = false;
    }
    line += (begun ? " " : "") + word;
    begun = true;
  }
  text_ += line + "\n";
}

void Document::paragraph(const std::string& text) {
  gap();
  wrapped(text, "", "");
}

void Document::item(const std::string& text) {
  if (!in_list_) gap();
  in_list_ = true;
  wrapped(text, "* ", "  ");
}

void Document::table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows, std::size_t left) {
  gap();
  std::vector<std::size_t> widths;
  for (const std::string& cell : header) widths.push_back(std::max<std::size_t>(3, cell.size()));
  for (const std::vector<std::string>& row : rows) {
    BUMP_ASSERT(row.size() == header.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text = markdown_ ? "|" : "";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string cell = padded(cells[i], widths[i], i < left);
      text += markdown_ ? " " + cell + " |" : (i == 0 ? "  " : "   ") + cell;
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    text_ += text + "\n";
  };
  line(header);
  std::vector<std::string> rule;
  for (std::size_t i = 0; i < header.size(); ++i)
    rule.push_back(markdown_ && i >= left ? std::string(widths[i] - 1, '-') + ":" : std::string(widths[i], '-'));
  line(rule);
  for (const std::vector<std::string>& row : rows) line(row);
}

}  // namespace bump
