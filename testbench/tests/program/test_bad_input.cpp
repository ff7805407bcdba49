// Every wrong input ends with code 2 and a text that says what, where and what to try; nothing is written.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program_runner.h"

using namespace bump;
namespace fs = std::filesystem;

namespace {

struct Case {
  const char* arguments;
  const char* says;
};

}  // namespace

TEST_CASE("wrong arguments and settings are explained") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("misspelt.toml", "[fifos]\ndepht = 3\n");
  folder.write("range.toml", "[fifos]\ndepth = 0\n");
  folder.write("broken.toml", "[fifos\ndepth = 3\n");
  const Case cases[] = {
      {"", "subcommand"},
      {"run", "scene"},
      {"rnu scene.toml", "try: bumpsim run"},
      {"frob", "there is no command 'frob'"},
      {"frob", "run, compare, table1, table2"},
      {"run scene.toml --out ''", "--out"},
      {"run scene.toml --out=", "--out"},
      {"luts --out ''", "--out"},
      {"run scene.toml --frobnicate", "frobnicate"},
      {"run nowhere.toml", "nowhere.toml"},
      {"run world_spere", "world_sphere"},
      {"run scene.toml --scheme lee2008", "lee2007"},
      {"run scene.toml --engine fast", "dated"},
      {"run scene.toml --set fifos.depht=2", "fifos.depth"},
      {"run scene.toml --set fifos.depth=0", "allowed"},
      {"run scene.toml --set fifos.depth=1e9", "fifos.depth"},
      {"run scene.toml --set fifos.depth=many", "fifos.depth"},
      {"run scene.toml --set fifos.depth", "="},
      {"run scene.toml --set clock.megahertz=nan", "clock.megahertz"},
      {"run scene.toml --set rasterizer.order=spiral", "tiled"},
      {"run scene.toml --config misspelt.toml", "misspelt.toml:2"},
      {"run scene.toml --config range.toml", "range.toml:2"},
      {"run scene.toml --config broken.toml", "broken.toml:1"},
      {"run scene.toml --config missing.toml", "missing.toml"},
      {"describe fifo", "fifos"},
      {"describe nothing_like_it", "bumpsim describe"},
      {"list pictures", "schemes"},
      {"check nowhere.toml", "nowhere.toml"},
      {"probe lee2007 illuminaton", "illumination"},
      {"probe lee2007 environment L.phi=40", "L.theta"},
      {"probe lee2007 environment L.phi=forty", "forty"},
      {"probe lee2007 environment nonsense", "name=value"},
      {"probe lee2009 environment", "lee2007"},
      {"luts --out /proc/luts", "/proc/luts"},
  };
  for (const Case& wrong : cases) {
    const Outcome outcome = bumpsim(wrong.arguments, folder.path());
    INFO(wrong.arguments << "\n" << outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("bumpsim: ") == 0);
    CHECK(outcome.err.find(wrong.says) != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "out"));
  }
}

TEST_CASE("a text that is not a scene is explained with its place") {
  const TemporaryFolder folder;
  const std::string good = small_scene();
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
  };
  const std::pair<std::string, const char*> cases[] = {
      {"", "scene.toml"},
      {with("eye = [0.5, -3.2, 1.4]", "eye = [nan, 0, 1]"), "eye"},
      {with("eye = [0.5, -3.2, 1.4]", "eye = [0, 0, 0]"), "target"},
      {with("field_of_view", "feild_of_view"), "field_of_view"},
      {with("field_of_view = 40", "field_of_view = 400"), "field_of_view"},
      {with("width = 96", "width = 0"), "width"},
      {with("shape = \"sphere\"", "shape = \"spere\""), "sphere"},
      {with("colour = [0.8, 0.7, 0.6]", "colour = \"missing.png\""), "missing.png"},
      {with("colour = [0.8, 0.7, 0.6]", "colour = \"scene.toml\""), "scene.toml"},
      {with("type = \"directional\"", "type = \"spot\""), "directional"},
      {with("diffuse = 0.5", "diffuse = -1"), "diffuse"},
  };
  for (const auto& [text, says] : cases) {
    folder.write("scene.toml", text);
    for (const std::string command : {"run", "check"}) {
      const Outcome outcome = bumpsim(command + " scene.toml", folder.path());
      INFO(command << "\n" << text << "\n" << outcome.err);
      CHECK(outcome.code == 2);
      CHECK(outcome.err.find("scene.toml") != std::string::npos);
      CHECK(outcome.err.find(says) != std::string::npos);
      CHECK_FALSE(fs::exists(folder.path() / "out"));
    }
  }
}

TEST_CASE("with --json a failure is one document on stdout, and still a text on stderr") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  folder.write("misspelt.toml", "[fifos]\ndepht = 3\n");
  const std::string stuck = " --set texture_fetch.batch=8 --set fifos.interpolators_to_texture_fetch=5";
  const struct {
    std::string arguments;
    int code;
    const char* status;
  } cases[] = {
      {"run nowhere.toml --json", 2, "error"},
      {"run scene.toml --json --frobnicate", 2, "error"},
      {"frob --json", 2, "error"},
      {"run scene.toml --json --config misspelt.toml", 2, "error"},
      {"check nowhere.toml --json", 2, "error"},
      {"describe fifo --json", 2, "error"},
      {"list pictures --json", 2, "error"},
      {"luts --out /proc/luts --json", 2, "error"},
      {"probe lee2009 environment --json", 2, "error"},
      {"run scene.toml --json --no-quality" + stuck, 3, "deadlock"},
  };
  for (const auto& wrong : cases) {
    const Outcome outcome = bumpsim(wrong.arguments, folder.path());
    INFO(wrong.arguments << "\n" << outcome.out << outcome.err);
    CHECK(outcome.code == wrong.code);
    REQUIRE(nlohmann::json::accept(outcome.out));
    const nlohmann::json document = nlohmann::json::parse(outcome.out);
    CHECK(document["status"] == wrong.status);
    CHECK(outcome.err.find(document["error"]["what"].get<std::string>()) != std::string::npos);
    for (const char* part : {"file", "line", "column", "why", "try"}) CHECK(document["error"].contains(part));
  }
  const auto error = nlohmann::json::parse(bumpsim("run scene.toml --json --config misspelt.toml", folder.path()).out)["error"];
  CHECK(error["file"] == "misspelt.toml");
  CHECK(error["line"] == 2);
}

TEST_CASE("a symbolic link to nothing is no place for a result") {
  const TemporaryFolder folder;
  folder.write("scene.toml", small_scene());
  fs::create_symlink("nothing", folder.path() / "link");
  for (const std::string out : {"link", "link/below"}) {
    const Outcome outcome = bumpsim("run scene.toml --out " + out, folder.path());
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("link") != std::string::npos);
  }
  CHECK(fs::is_symlink(folder.path() / "link"));
}
