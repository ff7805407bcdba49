#include <catch2/catch.hpp>

#include "testbench/results/text_table.h"

using namespace bump;

namespace {

const TextTable table{{"name", "count"}, {{"a|b", "1"}, {"longer", "12345678"}, {"", ""}}, 1};

}  // namespace

TEST_CASE("aligned columns are as wide as their widest cell and lines have no blanks at their ends") {
  CHECK(aligned(table) ==
        "  name       count\n"
        "  ----------------\n"
        "  a|b            1\n"
        "  longer  12345678\n"
        "\n");
}

TEST_CASE("Markdown tables escape what would end a cell") {
  CHECK(markdown(table) == "| name | count |\n|--|--:|\n| a\\|b | 1 |\n| longer | 12345678 |\n| | |\n");
}

TEST_CASE("CSV fields are quoted where they must be") {
  CHECK(csv_line({"plain", "", "a,b", "say \"so\"", "two\nlines"}) == "plain,,\"a,b\",\"say \"\"so\"\"\",\"two\nlines\"\n");
}

TEST_CASE("folded text keeps its words and its width") {
  const std::string words = "one two three four fivefivefivefive six";
  for (std::size_t width = 4; width < 50; ++width) {
    const std::string text = folded(words, width, "* ");
    CHECK(text.substr(0, 2) == "* ");
    std::string joined;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; begin = end + 1, end = text.find('\n', begin)) {
      const std::string line = text.substr(begin, end - begin);
      const bool one_word = line.find(' ', 2) == std::string::npos;
      CHECK((line.size() <= width || one_word));
      joined += (joined.empty() ? "" : " ") + line.substr(2);
    }
    CHECK(joined == words);
  }
}
