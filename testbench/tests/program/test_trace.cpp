// The waveform file of `bumpsim run --trace` appears whole or not at all.

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program_runner.h"

using namespace bump;
namespace fs = std::filesystem;

namespace {

const std::string stepped = "run scene.toml --no-quality --engine stepped ";
/// Limits files to 256 blocks of 512 bytes: less than the waveforms need, more than anything else.
const std::string little_room = "sh -c 'ulimit -f 256; exec \"$@\"' sh";

std::vector<std::string> names(const fs::path& folder) {
  std::vector<std::string> list;
  for (const auto& entry : fs::directory_iterator(folder)) list.push_back(entry.path().filename().string());
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

TEST_CASE("waveforms go where they are told to, with the suffix of their kind") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim(stepped + "--trace waves --out r", folder.path()).code == 0);
  CHECK(names(folder.path()) == std::vector<std::string>{"r", "scene.toml", "waves.vcd"});
  CHECK(read_file(folder.path() / "waves.vcd").back() == '\n');
}

TEST_CASE("earlier waveforms are replaced only with --force") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("waves.vcd", "precious");
  for (const std::string name : {"waves", "waves.vcd"}) {
    const Outcome refused = bumpsim(stepped + "--out r --trace " + name, folder.path());
    CHECK(refused.code == 2);
    CHECK(refused.err.find("--force") != std::string::npos);
    CHECK(read_file(folder.path() / "waves.vcd") == "precious");
  }
  CHECK(bumpsim(stepped + "--out r --force --trace waves.vcd", folder.path()).code == 0);
  CHECK(read_file(folder.path() / "waves.vcd").find("$enddefinitions") != std::string::npos);
  CHECK(names(folder.path()) == std::vector<std::string>{"r", "scene.toml", "waves.vcd"});
}

TEST_CASE("a place that is no file is refused before the simulation") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  fs::create_directory(folder.path() / "sub");
  fs::create_directory(folder.path() / "sub.vcd");
  fs::create_directory(folder.path() / "r");
  for (const std::string place : {".", "..", "sub", "sub/", "sub.vcd", "''", "r/waves.vcd", "missing/waves.vcd"}) {
    const Outcome outcome = bumpsim(stepped + "--out r --force --trace " + place, folder.path());
    INFO(place << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("trace") != std::string::npos);
  }
  CHECK(names(folder.path()) == std::vector<std::string>{"r", "scene.toml", "sub", "sub.vcd"});
  CHECK(fs::is_empty(folder.path() / "r"));
}

TEST_CASE("waveforms that find no room are an error, and leave nothing behind but the earlier ones") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("waves.vcd", "precious");
  const Outcome outcome = bumpsim(stepped + "--out r --force --trace waves.vcd", folder.path(), little_room);
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.err.find("waves.vcd") != std::string::npos);
  CHECK(outcome.err.find("clock edges") != std::string::npos);
  CHECK(read_file(folder.path() / "waves.vcd") == "precious");
  CHECK(names(folder.path()) == std::vector<std::string>{"scene.toml", "waves.vcd"});
}

TEST_CASE("an interruption leaves no half-written waveforms, by whatever signal") {
  const TemporaryFolder folder;
  folder.write("scene.toml", "[frame]\nwidth = 4096\nheight = 4096\n" + small_scene().substr(small_scene().find("[camera]")));
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    // The frame takes many seconds; the signal comes as soon as the waveforms have begun. env: a shell tells its background jobs to ignore
    // some signals.
    const std::string when_it_writes = "sh -c '\"$@\" & until ls *.partial-* >/dev/null 2>&1; do sleep 0.05; done; sleep 0.3; kill -" + signal +
                                       " $!; wait $!' sh env --default-signal=INT,HUP,TERM";
    const Outcome outcome = bumpsim(stepped + "--json --out r --trace waves.vcd", folder.path(), when_it_writes);
    INFO(signal << "\n" << outcome.err);
    CHECK(outcome.code == 130);
    REQUIRE(nlohmann::json::accept(outcome.out));
    CHECK(nlohmann::json::parse(outcome.out)["status"] == "interrupted");
    CHECK(names(folder.path()) == std::vector<std::string>{"scene.toml"});
  }
}

TEST_CASE("a signal that the process was told to ignore stays ignored") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const std::string wrapper = "sh -c 'trap \"\" INT HUP; \"$@\" & sleep 0.1; kill -INT $!; kill -HUP $!; wait $!' sh";
  CHECK(bumpsim(stepped + "--out r", folder.path(), wrapper).code == 0);
}

TEST_CASE("a deadlock leaves no waveforms") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const std::string stuck = "--set texture_fetch.batch=8 --set fifos.interpolators_to_texture_fetch=5 ";
  CHECK(bumpsim(stepped + stuck + "--out r --trace waves.vcd", folder.path()).code == 3);
  CHECK(names(folder.path()) == std::vector<std::string>{"scene.toml"});
}
