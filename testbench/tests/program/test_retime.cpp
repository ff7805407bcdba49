// `bumpsim run --record` and `bumpsim retime` as a user meets them.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A folder with a scene and a trace of it.
void record(const TemporaryFolder& folder, const std::string& arguments = "") {
  folder.write("scene.toml", small_scene());
  const Outcome outcome = bumpsim("run scene.toml --no-quality --out r --record scene.trace " + arguments, folder.path());
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  REQUIRE(fs::exists(folder.path() / "scene.trace"));
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("retime says of time what a run with those settings says") {
  const TemporaryFolder folder;
  record(folder, "--scheme peercy1997");
  const std::string settings =
      " --set fifos.depth=2 --set memory.latency=90 --set environment.multipliers=9 --set datapath.latency.multiplier=3";
  int number = 0;
  for (const std::string& changed : {std::string(), settings}) {
    const Outcome run =
        bumpsim("run scene.toml --scheme peercy1997 --no-quality --json --out r" + std::to_string(++number) + "x" + changed, folder.path());
    const Outcome retimed = bumpsim("retime scene.trace --json" + changed, folder.path());
    INFO(run.err << retimed.err);
    REQUIRE(run.code == 0);
    REQUIRE(retimed.code == 0);
    const Json expected = Json::parse(run.out), said = Json::parse(retimed.out);
    for (const char* part : {"cycles", "fragments_per_cycle", "frames_per_second", "bound", "modules", "fifos", "memory", "inputs"}) {
      INFO(part);
      CHECK(said[part] == expected[part]);
    }
    CHECK(said["changed"].size() == (changed.empty() ? 0 : 4));
  }
}

TEST_CASE("a sweep has a row for each point, in all formats") {
  const TemporaryFolder folder;
  record(folder);
  const std::string command = "retime scene.trace --sweep fifos.depth=1,2,8 --sweep memory.latency=10,99 --set texture_fetch.capacity=5";
  const Outcome json = bumpsim(command + " --json", folder.path());
  REQUIRE(json.code == 0);
  const Json document = Json::parse(json.out);
  CHECK(document["points"] == 6);
  REQUIRE(document["rows"].size() == 6);
  const Json& row = document["rows"][3];
  CHECK(row["parameters"] == Json({{"fifos.depth", 2}, {"memory.latency", 99}}));
  const Outcome single =
      bumpsim("retime scene.trace --json --set texture_fetch.capacity=5 --set fifos.depth=2 --set memory.latency=99", folder.path());
  const Json alone = Json::parse(single.out);
  for (const char* part : {"cycles", "fragments_per_cycle", "frames_per_second", "bound", "modules"}) CHECK(row[part] == alone[part]);

  const Outcome csv = bumpsim(command + " --format csv --jobs 1", folder.path());
  CHECK(lines(csv.out) == 7);
  CHECK(csv.out.rfind("fifos.depth,memory.latency,status,cycles,", 0) == 0);
  CHECK(csv.out == bumpsim(command + " --format csv --jobs 5", folder.path()).out);
  const Outcome text = bumpsim(command, folder.path());
  CHECK(text.out.find("6 points") != std::string::npos);
  CHECK(text.out.find("changed: texture_fetch.capacity = 5") != std::string::npos);
  CHECK(text.err.empty());
}

TEST_CASE("points that deadlock are rows with their reason") {
  const TemporaryFolder folder;
  record(folder);
  const Outcome some = bumpsim("retime scene.trace --sweep texture_fetch.batch=1,8 --format csv", folder.path());
  CHECK(some.code == 0);
  CHECK(some.out.find("\n8,deadlock,") != std::string::npos);
  CHECK(some.out.find("fifos.interpolators_to_texture_fetch at least 8") != std::string::npos);
  CHECK(some.err.find("1 of 2 points deadlock") != std::string::npos);
  CHECK(bumpsim("retime scene.trace --sweep texture_fetch.batch=8,9", folder.path()).code == 3);
  CHECK(bumpsim("retime scene.trace --set texture_fetch.batch=8", folder.path()).code == 3);
}

TEST_CASE("what is more than timing is refused with its reason") {
  const TemporaryFolder folder;
  record(folder);
  for (const std::string setting : {"--set texture_fetch.cache.sets=64", "--sweep texture_fetch.cache.sets=64,32"}) {
    const Outcome outcome = bumpsim("retime scene.trace " + setting, folder.path());
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("texture_fetch.cache.sets") != std::string::npos);
    CHECK(outcome.err.find("record again") != std::string::npos);
    CHECK(outcome.err.find("--addresses") != std::string::npos);
  }
  CHECK(bumpsim("retime scene.trace --set texture_fetch.cache.sets=32", folder.path()).code == 0);
  folder.write("same.toml", "[texture_fetch.cache]\nsets = 32\n[fifos]\ndepth = 2\n");
  CHECK(bumpsim("retime scene.trace --config same.toml", folder.path()).code == 0);
}

TEST_CASE("with addresses, retime says of caches what a run with them says, in all formats") {
  const TemporaryFolder folder;
  record(folder, "--scheme kugler1998 --set kugler1998.light_map_bits=11 --addresses");
  const std::string settings =
      " --set texture_fetch.cache.sets=2 --set texture_fetch.cache.line_bytes=16 --set light_map_fetch.cache.ways=1 --set "
      "memory.latency=90";
  const Outcome run = bumpsim(
      "run scene.toml --scheme kugler1998 --set kugler1998.light_map_bits=11 --no-quality --json --out rx" + settings, folder.path());
  const Outcome retimed = bumpsim("retime scene.trace --json" + settings, folder.path());
  INFO(run.err << retimed.err);
  REQUIRE(run.code == 0);
  REQUIRE(retimed.code == 0);
  const Json expected = Json::parse(run.out), said = Json::parse(retimed.out);
  for (const char* part : {"cycles", "bound", "modules", "fifos", "memory", "texture"}) {
    INFO(part);
    CHECK(said[part] == expected[part]);
  }
  REQUIRE(said["light_maps"].size() == expected["light_maps"].size());
  for (std::size_t i = 0; i < said["light_maps"].size(); ++i)
    for (const auto& [name, value] : said["light_maps"][i].items()) CHECK(value == expected["light_maps"][i][name]);

  const std::string sweep =
      "retime scene.trace --set light_map_fetch.cache.ways=1 --set texture_fetch.cache.line_bytes=16 --sweep texture_fetch.cache.sets=2,64 "
      "--sweep memory.latency=90,10";
  const Outcome json = bumpsim(sweep + " --json", folder.path());
  REQUIRE(json.code == 0);
  const Json row = Json::parse(json.out)["rows"][0];
  for (const char* part : {"cycles", "bound", "modules", "texture", "light_maps"}) CHECK(row[part] == said[part]);
  const Outcome csv = bumpsim(sweep + " --format csv --jobs 1", folder.path());
  CHECK(csv.out.find(",texture.hit_rate,texture.bytes,light_map.") != std::string::npos);
  CHECK(csv.out == bumpsim(sweep + " --format csv --jobs 4", folder.path()).out);
  const Outcome text = bumpsim(sweep, folder.path());
  CHECK(text.out.find("texture hits") != std::string::npos);
  CHECK(text.out.find("light-map KB") != std::string::npos);
}

TEST_CASE("caches that cannot be built, and addresses without a trace, are bad input") {
  const TemporaryFolder folder;
  record(folder, "--addresses");
  const Outcome odd = bumpsim("retime scene.trace --sweep texture_fetch.cache.sets=2,3", folder.path());
  CHECK(odd.code == 2);
  CHECK(odd.err.find("power of two") != std::string::npos);
  const Outcome filter = bumpsim("retime scene.trace --sweep texture_fetch.filter=nearest", folder.path());
  CHECK(filter.code == 2);
  CHECK(filter.err.find("record again") != std::string::npos);
  const Outcome alone = bumpsim("run scene.toml --no-quality --out other --addresses", folder.path());
  CHECK(alone.code == 2);
  CHECK(alone.err.find("--record") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "other"));
}

TEST_CASE("files that are no traces, and sweeps that are none, are bad input") {
  const TemporaryFolder folder;
  record(folder);
  const std::string bytes = read_file(folder.path() / "scene.trace");
  folder.write("short.trace", bytes.substr(0, bytes.size() / 2));
  folder.write("empty.trace", "");
  for (const std::string arguments :
       {"scene.toml", "short.trace", "empty.trace", "missing.trace", "r", "scene.trace --sweep fifos.depth", "scene.trace --sweep depth=1",
        "scene.trace --sweep fifos.depth=1,1", "scene.trace --sweep fifos.depth=", "scene.trace --set nonsense=1"}) {
    const Outcome outcome = bumpsim("retime --json " + arguments, folder.path());
    INFO(arguments << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(Json::parse(outcome.out)["status"] == "error");
  }
}

TEST_CASE("a trace is written whole or not at all, and never over another file unless told to") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("scene.trace", "bumptrc\nprecious");
  const std::string command = "run scene.toml --no-quality --out r --record ";
  const Outcome refused = bumpsim(command + "scene.trace", folder.path());
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--record") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "r"));
  CHECK(read_file(folder.path() / "scene.trace") == "bumptrc\nprecious");
  CHECK(bumpsim(command + "r/scene.trace", folder.path()).code == 2);
  CHECK(bumpsim(command + "''", folder.path()).code == 2);
  CHECK_FALSE(fs::exists(folder.path() / "r"));
  CHECK(bumpsim(command + "scene.trace --force", folder.path()).code == 0);
  CHECK(bumpsim("retime scene.trace", folder.path()).code == 0);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path())) ++files;
  CHECK(files == 3);
}

TEST_CASE("a record replaces nothing but a record, and shares no file with waveforms") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const std::string run = "run scene.toml --no-quality --engine stepped --force --out r --record ";
  const Outcome slip = bumpsim(run + "scene.toml", folder.path());
  CHECK(slip.code == 2);
  CHECK(slip.err.find("is no timing trace") != std::string::npos);
  CHECK(read_file(folder.path() / "scene.toml") == small_scene());
  CHECK(bumpsim(run + "x.vcd --trace x", folder.path()).code == 2);
  CHECK(bumpsim(run + "x.vcd --trace x.vcd", folder.path()).err.find("same file") != std::string::npos);
  folder.write("empty", "");
  CHECK(bumpsim(run + "empty", folder.path()).code == 0);
  CHECK(bumpsim(run + "empty", folder.path()).code == 0);
}

TEST_CASE("what retime proposes to record again has the settings of the recorded run") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim("run scene.toml --no-quality --out r --record t --set rasterizer.order=tiled", folder.path()).code == 0);
  for (const std::string key : {"texture_fetch.cache.sets=2", "texture_fetch.filter=nearest"}) {
    const Outcome outcome = bumpsim("retime t --set " + key, folder.path());
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("--set rasterizer.order=tiled") != std::string::npos);
    CHECK(outcome.err.find("scene.toml") != std::string::npos);
  }
  CHECK(bumpsim("retime t --set fifos.depth=3 --sweep fifos.depth=1,2", folder.path()).err.find("both set and swept") != std::string::npos);
}
