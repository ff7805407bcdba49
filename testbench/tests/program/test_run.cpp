// `bumpsim run` as a user meets it.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

Json without_host(const fs::path& result) {
  Json document = Json::parse(read_file(result / "result.json"));
  document.erase("host");
  document.erase("engine");
  return document;
}

}  // namespace

TEST_CASE("a run of a small scene writes a whole result and says where") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const Outcome run = bumpsim("run scene.toml --out result", folder.path());
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.out.find("result in result") != std::string::npos);
  for (const char* name : {"result.json", "config.resolved.toml", "stats.csv", "frame.png", "frame.exr", "error.png"}) {
    INFO(name);
    CHECK(fs::file_size(folder.path() / "result" / name) > 0);
  }
}

TEST_CASE("both engines give the same result for every scheme") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const Outcome list = bumpsim("list schemes --json", folder.path());
  REQUIRE(list.code == 0);
  const Json schemes = Json::parse(list.out)["schemes"];
  REQUIRE(schemes.size() >= 2);
  for (const Json& scheme : schemes) {
    const std::string id = scheme["id"];
    INFO(id);
    const std::string tight = " --set fifos.depth=1 --set memory.outstanding=1 --set environment.multipliers=2 --set rasterizer.order=tiled";
    REQUIRE(bumpsim("run scene.toml --scheme " + id + tight + " --out dated-" + id, folder.path()).code == 0);
    REQUIRE(bumpsim("run scene.toml --scheme " + id + tight + " --engine stepped --out stepped-" + id, folder.path()).code == 0);
    CHECK(without_host(folder.path() / ("dated-" + id)) == without_host(folder.path() / ("stepped-" + id)));
    CHECK(read_file(folder.path() / ("dated-" + id) / "frame.exr") == read_file(folder.path() / ("stepped-" + id) / "frame.exr"));
  }
}

TEST_CASE("the same bytes come from any folder") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "elsewhere");
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim("run scene.toml --out a", folder.path()).code == 0);
  REQUIRE(bumpsim("run ../scene.toml --out ../b", folder.path() / "elsewhere").code == 0);
  CHECK(without_host(folder.path() / "a") == without_host(folder.path() / "b"));
  for (const char* name : {"config.resolved.toml", "stats.csv", "frame.png", "frame.exr", "error.png"}) {
    INFO(name);
    CHECK(read_file(folder.path() / "a" / name) == read_file(folder.path() / "b" / name));
  }
}

TEST_CASE("the number of threads does not change a byte") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  for (const char* jobs : {"1", "2", "5"})
    REQUIRE(bumpsim(std::string("run scene.toml --out jobs-") + jobs + " --jobs " + jobs, folder.path()).code == 0);
  for (const char* other : {"jobs-2", "jobs-5"}) {
    CHECK(without_host(folder.path() / "jobs-1") == without_host(folder.path() / other));
    for (const char* file : {"stats.csv", "frame.exr", "frame.png", "error.png"})
      CHECK(read_file(folder.path() / "jobs-1" / file) == read_file(folder.path() / other / file));
  }
  CHECK(bumpsim("run scene.toml --jobs -1", folder.path()).code == 2);
}

TEST_CASE("double precision has no quantisation error and fixed point has some") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const Outcome real = bumpsim("run scene.toml --json --set numeric=double", folder.path());
  REQUIRE(real.code == 0);
  CHECK(Json::parse(real.out)["quality"]["against_double"]["max_error"] == 0.0);
  const Outcome fixed = bumpsim("run scene.toml --json", folder.path());
  REQUIRE(fixed.code == 0);
  CHECK(Json::parse(fixed.out)["quality"]["against_double"]["max_error"] > 0.0);
}

TEST_CASE("runs without --out never touch an earlier result") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim("run scene.toml", folder.path()).code == 0);
  const std::string first = read_file(folder.path() / "out/scene-lee2007/result.json");
  REQUIRE(bumpsim("run scene.toml", folder.path()).code == 0);
  CHECK(read_file(folder.path() / "out/scene-lee2007/result.json") == first);
  CHECK(fs::exists(folder.path() / "out/scene-lee2007-2/result.json"));
}

TEST_CASE("an existing result is replaced only with --force, and nothing else ever") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim("run scene.toml --out r", folder.path()).code == 0);
  const Outcome refused = bumpsim("run scene.toml --out r", folder.path());
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--force") != std::string::npos);
  CHECK(bumpsim("run scene.toml --out r --force --scheme peercy1997", folder.path()).code == 0);
  fs::create_directory(folder.path() / "mine");
  folder.write("mine/notes.txt", "precious");
  CHECK(bumpsim("run scene.toml --out mine --force", folder.path()).code == 2);
  folder.write("r/notes.txt", "precious");
  const Outcome kept = bumpsim("run scene.toml --out r --force", folder.path());
  CHECK(kept.code == 2);
  CHECK(kept.err.find("notes.txt") != std::string::npos);
  CHECK(read_file(folder.path() / "r/notes.txt") == "precious");
  CHECK(read_file(folder.path() / "mine/notes.txt") == "precious");
}

TEST_CASE("a deadlock made on purpose ends with its wait-for chain, a remedy that works, and code 3") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  const std::string stuck = "run scene.toml --out r --set texture_fetch.batch=8 --set fifos.interpolators_to_texture_fetch=5";
  for (const std::string engine : {"dated", "stepped"}) {
    const Outcome outcome = bumpsim(stuck + " --engine " + engine, folder.path());
    INFO(outcome.err);
    CHECK(outcome.code == 3);
    CHECK(outcome.err.find("texture_fetch waits for") != std::string::npos);
    CHECK(outcome.err.find("holds 5 of 5") != std::string::npos);
    CHECK(outcome.err.find("at least 8") != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "r"));
  }
  CHECK(bumpsim("run scene.toml --out r --set texture_fetch.batch=8 --set fifos.interpolators_to_texture_fetch=8", folder.path()).code == 0);
}

TEST_CASE("an interrupted run leaves nothing behind and ends with code 130") {
  const TemporaryFolder folder;
  folder.write("scene.toml", "[frame]\nwidth = 4096\nheight = 4096\n" + small_scene().substr(small_scene().find("[camera]")));
  // The frame takes many seconds; the signal comes long before.
  const Outcome outcome = bumpsim("run scene.toml --engine stepped --out r", folder.path(), "timeout --preserve-status -s INT 3");
  CHECK(outcome.code == 130);
  CHECK_FALSE(fs::exists(folder.path() / "r"));
  for (const auto& entry : fs::directory_iterator(folder.path())) CHECK(entry.path().filename() == "scene.toml");
}

TEST_CASE("the clocked engine writes waveforms and the dated one says why it cannot") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  REQUIRE(bumpsim("run scene.toml --engine stepped --trace waves.vcd --out r", folder.path()).code == 0);
  const std::string waves = read_file(folder.path() / "waves.vcd");
  CHECK(waves.find("$enddefinitions") != std::string::npos);
  CHECK(waves.find("texture_fetch") != std::string::npos);
  const Outcome refused = bumpsim("run scene.toml --trace waves.vcd --out r2", folder.path());
  CHECK(refused.code == 2);
  CHECK(refused.err.find("--engine stepped") != std::string::npos);
  CHECK(bumpsim("run scene.toml --engine stepped --trace /nowhere/waves.vcd --out r3", folder.path()).code == 2);
}

TEST_CASE("a run goes on when its warnings cannot be printed") {
  const TemporaryFolder folder;
  std::string scene = small_scene();
  const std::string target = "target = [0, 0, 0]";
  scene.replace(scene.find(target), target.size(), "target = [0, -99, 0]");  // looks away: nothing is seen, which is warned of
  folder.write("scene.toml", scene);
  CHECK(bumpsim("run scene.toml --no-quality --out seen", folder.path()).err.find("warning") != std::string::npos);
  for (const std::string stream : {"2>/dev/full", "2>&-"}) {
    INFO(stream);
    CHECK(bumpsim("run scene.toml --no-quality --force --out r " + stream, folder.path()).code == 0);
  }
  // A pipe that nobody reads.
  bumpsim("run scene.toml --no-quality --out piped", folder.path(), "sh -c '\"$@\" 2>&1 >/dev/null | true' sh");
  CHECK(fs::exists(folder.path() / "piped/result.json"));
}

TEST_CASE("a full disk or an unwritable place is an error and leaves nothing half-written") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("file", "in the way");
  CHECK(bumpsim("run scene.toml --out file", folder.path()).code == 2);
  CHECK(bumpsim("run scene.toml --out file/below", folder.path()).code == 2);
  CHECK(bumpsim("run scene.toml --out /proc/result", folder.path()).code == 2);
  CHECK(read_file(folder.path() / "file") == "in the way");
  const Outcome full = bumpsim("run scene.toml --json --out r >/dev/full", folder.path());
  CHECK(full.code == 2);
  CHECK(full.err.find("standard output") != std::string::npos);
}
