// Reports for readers: the same content as plain text and as Markdown.

#include <catch2/catch.hpp>
#include <sstream>

#include "testbench/experiments/document.h"

namespace bump {
namespace {

std::string sample(bool markdown) {
  Document document(markdown);
  document.heading(1, "Title");
  std::string words;
  for (int i = 0; i < 60; ++i) words += "word" + std::to_string(i) + " ";
  document.paragraph(words);
  document.item("first");
  document.item(words);
  document.table({"name", "value"}, {{"a", "1"}, {"long name", "12345"}}, 1);
  return document.text();
}

TEST_CASE("plain text keeps its lines within their width and loses no word") {
  std::istringstream lines(sample(false));
  std::string line, all;
  while (std::getline(lines, line)) {
    CHECK(line.size() <= Document::columns);
    CHECK((line.empty() || line.back() != ' '));
    all += line + " ";
  }
  for (int i = 0; i < 60; ++i) {
    const std::size_t first = all.find("word" + std::to_string(i) + " ");
    REQUIRE(first != std::string::npos);
    CHECK(all.find("word" + std::to_string(i) + " ", first + 1) != std::string::npos);
  }
}

TEST_CASE("tables are aligned in text, and complete in Markdown") {
  CHECK(sample(false).find("  name        value\n  ---------   -----\n  a               1\n  long name   12345\n") != std::string::npos);
  CHECK(sample(true).find("| name      | value |\n| --------- | ----: |\n| a         |     1 |\n| long name | 12345 |\n") !=
        std::string::npos);
  CHECK(sample(true).find("# Title\n") == 0);
  CHECK(sample(true).find("\n* first\n* word0 ") != std::string::npos);
}

}  // namespace
}  // namespace bump
