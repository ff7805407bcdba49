// `bumpsim table2` as a user meets it, on small frames of the shipped scenes.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
}

/// The shipped scenes as small frames, in the folder's "scenes".
void write_small_scenes(const TemporaryFolder& folder) {
  const fs::path shipped = fs::path(BUMP_SOURCE_DIR) / "scenes";
  fs::create_directory(folder.path() / "scenes");
  for (const char* texture : {"wood", "brick", "world"})
    fs::create_directory_symlink(shipped / texture, folder.path() / "scenes" / texture);
  for (const char* name : {"wood_plane.toml", "brick_cube.toml", "world_sphere.toml"}) {
    std::string text = read_file(shipped / name);
    replace_all(text, "= 512", "= 32");
    folder.write(std::string("scenes/") + name, text);
  }
}

}  // namespace

TEST_CASE("table2 prints the table, and writes the same to a file and beside the pictures") {
  const TemporaryFolder folder;
  write_small_scenes(folder);
  const Outcome text = bumpsim("table2 --pictures p", folder.path());
  INFO(text.err);
  REQUIRE(text.code == 0);
  CHECK(text.out.find("32 x 32") != std::string::npos);
  CHECK(text.out.find("What reproduces and what cannot") != std::string::npos);
  const Json beside = Json::parse(read_file(folder.path() / "p" / "table2.json"));
  CHECK(beside["schema"] == "bumpsim-table2");
  // References once for both spaces, from heights where there are some; three pictures for each scene and space; the table.
  CHECK(std::distance(fs::directory_iterator(folder.path() / "p"), fs::directory_iterator()) == 3 + 2 + 3 * 2 * 3 + 1);
  CHECK(read_file(folder.path() / "p" / "sphere-eye-error.png").substr(1, 3) == "PNG");

  REQUIRE(bumpsim("table2 --format json --out t.json", folder.path()).code == 0);
  CHECK(Json::parse(read_file(folder.path() / "t.json")) == beside);
}

TEST_CASE("table2 refuses what it cannot do before it draws anything") {
  const TemporaryFolder folder;
  write_small_scenes(folder);
  folder.write("here.txt", "precious");
  fs::create_directory(folder.path() / "mine");
  folder.write("mine/notes.txt", "precious");
  const auto refused = [&](const std::string& arguments, const std::string& remedy) {
    const Outcome outcome = bumpsim("table2 " + arguments, folder.path());
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(remedy) != std::string::npos);
    CHECK(outcome.out.empty());
  };
  refused("--out here.txt", "--force");
  refused("--out mine", "folder");
  refused("--pictures mine --force", "--pictures");
  refused("--set vertex_processor.space=eye", "both spaces");
  refused("--set lee2007.angel_bits=9", "lee2007.angle_bits");
  refused("--format pdf", "--help");
  CHECK(read_file(folder.path() / "here.txt") == "precious");
  CHECK(std::distance(fs::directory_iterator(folder.path() / "mine"), fs::directory_iterator()) == 1);
}

TEST_CASE("pictures of table2 are replaced only with --force, and a missing scene is named") {
  const TemporaryFolder folder;
  write_small_scenes(folder);
  REQUIRE(bumpsim("table2 --pictures p", folder.path()).code == 0);
  CHECK(bumpsim("table2 --pictures p", folder.path()).code == 2);
  CHECK(bumpsim("table2 --pictures p --force --set numeric=double", folder.path()).code == 0);
  CHECK(Json::parse(read_file(folder.path() / "p" / "table2.json"))["settings"] == Json::array({"numeric=double"}));
  folder.write("scenes/brick_cube.toml", "[frame]\nwidth = 0\n");
  const Outcome broken = bumpsim("table2 --json", folder.path());
  CHECK(broken.code == 2);
  CHECK(broken.err.find("brick_cube.toml") + broken.out.find("brick_cube.toml") != 2 * std::string::npos);
}
