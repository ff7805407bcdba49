// A text file for --out: complete or not at all, and never over something else.

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "datapath/error.h"
#include "testbench/results/output_file.h"

namespace bump {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "bumpsim-output-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string operator()(const std::string& name) const { return (path / name).string(); }
  std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string refusal(const std::string& path, bool force) {
  try {
    check_output_file(path, force);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(!error.text().try_this.empty());
    return error.what();
  }
  return "";
}

TEST_CASE("a new file holds the text and nothing is left beside it") {
  const Folder folder;
  check_output_file(folder("new.txt"), false);
  CHECK(folder.entries() == 0);
  write_output_file(folder("new.txt"), "one\ntwo\n", false);
  CHECK(read(folder("new.txt")) == "one\ntwo\n");
  CHECK(folder.entries() == 1);
}

TEST_CASE("missing folders are made when the file is written, not before") {
  const Folder folder;
  check_output_file(folder("a/b/new.txt"), false);
  CHECK(folder.entries() == 0);
  write_output_file(folder("a/b/new.txt"), "text", false);
  CHECK(read(folder("a/b/new.txt")) == "text");
}

TEST_CASE("an existing file is replaced only when told to") {
  const Folder folder;
  write_output_file(folder("f"), "old", false);
  CHECK(refusal(folder("f"), false).find("--force") != std::string::npos);
  CHECK_THROWS_AS(write_output_file(folder("f"), "new", false), Error);
  CHECK(read(folder("f")) == "old");
  write_output_file(folder("f"), "new", true);
  CHECK(read(folder("f")) == "new");
  CHECK(folder.entries() == 1);
}

TEST_CASE("folders, pipes and nameless files are refused, also with force") {
  const Folder folder;
  fs::create_directory(folder("d"));
  REQUIRE(::mkfifo(folder("pipe").c_str(), 0600) == 0);
  write_output_file(folder("f"), "text", false);
  for (const std::string& name : {folder("d"), folder("d/"), folder("pipe"), folder("f/below"), std::string()}) {
    INFO(name);
    CHECK(!refusal(name, true).empty());
    CHECK_THROWS_AS(write_output_file(name, "text", true), Error);
  }
  CHECK(read(folder("f")) == "text");
}

}  // namespace
}  // namespace bump
