// The commands that only answer: list, describe, check, luts, probe.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("the program lists the schemes and the shipped scenes") {
  const TemporaryFolder folder;
  const Outcome text = bumpsim("list", folder.path());
  REQUIRE(text.code == 0);
  for (const char* name : {"lee2007", "peercy1997", "wood_plane", "brick_cube", "world_sphere", "brick_torus", "bunny"}) {
    INFO(name);
    CHECK(text.out.find(name) != std::string::npos);
  }
  const Json json = Json::parse(bumpsim("list --json", folder.path()).out);
  CHECK(json["scenes"].size() >= 5);
}

TEST_CASE("everything can be described, and as JSON") {
  const TemporaryFolder folder;
  for (const std::string name : {"", "statistics", "lee2007", "peercy1997", "fifos", "texture_fetch.cache", "fifos.depth"}) {
    INFO(name);
    const Outcome text = bumpsim("describe " + name, folder.path());
    CHECK(text.code == 0);
    CHECK(text.out.size() > 40);
    const Outcome json = bumpsim("describe --json " + name, folder.path());
    CHECK(json.code == 0);
    CHECK(Json::accept(json.out));
  }
}

TEST_CASE("a good scene or configuration checks out") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("config.toml", "[fifos]\ndepth = 9\n[texture_fetch.cache]\nways = 2\n");
  const Json scene = Json::parse(bumpsim("check scene.toml --json", folder.path()).out);
  CHECK(scene["kind"] == "scene");
  CHECK(scene["objects"].size() == 2);
  const Json configuration = Json::parse(bumpsim("check config.toml --json", folder.path()).out);
  CHECK(configuration["kind"] == "configuration");
  CHECK(configuration["settings"]["fifos.depth"] == "9");
  CHECK(configuration["settings"].size() == 2);
}

TEST_CASE("a probe prints the nodes of the paper's first worked vector") {
  // Rotation of A = (40, 30) degrees by N = (0, 0): computed by hand from Lee 2007, Eqs 5 to 16.
  const TemporaryFolder folder;
  const Outcome probe =
      bumpsim("probe lee2007 environment N.phi=0 N.theta=0 L.phi=40 L.theta=30 H.phi=40 H.theta=30 --json", folder.path());
  INFO(probe.err);
  REQUIRE(probe.code == 0);
  const Json document = Json::parse(probe.out);
  const auto value = [&](const std::string& name) {
    for (const Json& node : document["nodes"])
      if (node["name"] == name) return node["double"].get<double>();
    FAIL("no node " << name);
    return 0.0;
  };
  CHECK(value("L.X") == Approx(70.0).margin(0.005));
  CHECK(value("L.Y") == Approx(-10.0).margin(0.005));
  CHECK(value("L.theta_x") == Approx(22.521).margin(0.0005));
  CHECK(value("L.prop") == Approx(0.2262).margin(0.00005));
}

TEST_CASE("the ROM images that are checked in are the ones that the program writes") {
  const TemporaryFolder folder;
  REQUIRE(bumpsim("luts --out written", folder.path()).code == 0);
  const fs::path checked_in = fs::path(BUMP_SOURCE_DIR) / "luts" / "rom";
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path() / "written")) {
    INFO(entry.path().filename() << ": if the change is meant, run `bumpsim luts` in the source folder");
    CHECK(read_file(entry.path()) == read_file(checked_in / entry.path().filename()));
    ++files;
  }
  CHECK(files > 5);
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(checked_in)) kept += entry.is_regular_file() ? 1 : 0;
  CHECK(kept == files);
}

TEST_CASE("help and version are no errors") {
  const TemporaryFolder folder;
  for (const char* arguments : {"--help", "run --help", "--version"}) {
    const Outcome outcome = bumpsim(arguments, folder.path());
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
  }
}

TEST_CASE("a scene of the working folder that hides a shipped one is used, and said to be") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "scenes");
  folder.write("scenes/world_sphere.toml", small_scene());
  const Outcome hidden = bumpsim("check world_sphere --json", folder.path());
  CHECK(hidden.code == 0);
  CHECK(Json::parse(hidden.out)["objects"].size() == 2);
  CHECK(hidden.err.find("scene 'world_sphere' is scenes/world_sphere.toml, not ") != std::string::npos);
  CHECK(bumpsim("check scenes/world_sphere.toml", folder.path()).err.empty());
  CHECK(bumpsim("check wood_plane", folder.path()).err.empty());
}
