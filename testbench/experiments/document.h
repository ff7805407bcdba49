#pragma once
// A report for readers in two spellings: plain text of bounded width, and Markdown. Headings, paragraphs, lists, tables; nothing else. No
// model of hardware.

#include <string>
#include <vector>

namespace bump {

class Document {
 public:
  static constexpr std::size_t columns = 110;  ///< of paragraphs and lists in plain text; tables take what they need

  explicit Document(bool markdown) : markdown_(markdown) {}

  /// Level 1 is the title.
  void heading(int level, const std::string& text);
  void paragraph(const std::string& text);
  void item(const std::string& text);
  /// Every row as long as the header. Columns are aligned to the right, but for the first `left`.
  void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows, std::size_t left);

  const std::string& text() const { return text_; }

 private:
  void gap();
  void wrapped(const std::string& text, const std::string& first, const std::string& others);

  bool markdown_, in_list_ = false;
  std::string text_;
};

}  // namespace bump
