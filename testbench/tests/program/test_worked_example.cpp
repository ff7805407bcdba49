// docs/worked_example.md is what it says: its commands run, and print the lines that it shows.

#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>

#include "program_runner.h"

using namespace bump;

namespace {

struct Fence {
  std::string language, name;  ///< name: of the file that the sentence in front of it gives, `...`:
  std::vector<std::string> lines;
};

std::vector<Fence> fences_of(const std::string& page) {
  std::istringstream text(page);
  std::vector<Fence> fences;
  std::string before;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("```", 0) == 0) {
      inside = !inside;
      std::smatch file;
      std::regex_search(before, file, std::regex("`([^` ]+)`:$"));
      if (inside) fences.push_back({line.substr(3), file.empty() ? "" : file[1].str(), {}});
    } else if (inside) {
      fences.back().lines.push_back(line);
    } else if (!line.empty()) {
      before = line;
    }
  }
  return fences;
}

/// Single spaces, so that the page need not repeat the widths of columns.
std::string squeezed(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex("[ \n]+"), " "), std::regex("^ | $"), "");
}

}  // namespace

TEST_CASE("the worked example runs, and prints what the page shows") {
  const TemporaryFolder folder;
  std::string printed;
  int commands = 0, shown = 0;
  for (const Fence& fence : fences_of(read_file(BUMP_SOURCE_DIR "/docs/worked_example.md"))) {
    if (fence.language == "toml") {
      REQUIRE_FALSE(fence.name.empty());
      std::string text;
      for (const std::string& line : fence.lines) text += line + "\n";
      folder.write(fence.name, text);
    } else if (fence.language == "sh") {
      printed.clear();
      for (const std::string& line : fence.lines) {
        const std::string program = "bumpsim ";
        REQUIRE(line.rfind(program, 0) == 0);
        const Outcome outcome = bumpsim(line.substr(program.size()), folder.path());
        INFO(line << "\n" << outcome.err);
        REQUIRE(outcome.code == 0);
        printed += outcome.out;
        ++commands;
      }
    } else {
      REQUIRE(fence.language == "text");
      for (const std::string& line : fence.lines) {
        INFO(line << "\nis not in\n" << printed);
        CHECK(squeezed(printed).find(squeezed(line)) != std::string::npos);
        ++shown;
      }
    }
  }
  CHECK(commands == 9);
  CHECK(shown > 20);
}
