// `bumpsim compare` as a user meets it.

#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "program_runner.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> files = {"compare.json", "compare.txt", "compare.md", "compare.csv", "compare.png"};

/// The picture is made of frames of this size.
std::string tiny_scene() {
  std::string scene = small_scene();
  scene.replace(scene.find("width = 96"), 10, "width = 48");
  scene.replace(scene.find("height = 80"), 11, "height = 40");
  return scene;
}

const Json& scheme_in(const Json& comparison, const std::string& id) {
  for (const Json& scheme : comparison["schemes"])
    if (scheme["id"] == id) return scheme;
  throw std::runtime_error("not compared: " + id);
}

}  // namespace

TEST_CASE("a comparison says of each scheme what a run of it says") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const std::string settings = " --set fifos.depth=2 --set lee2007.angles=pixel --set rasterizer.order=tiled";
  const Outcome compared = bumpsim("compare scene.toml --schemes lee2007,peercy1997 --json" + settings, folder.path());
  INFO(compared.err);
  REQUIRE(compared.code == 0);
  const Json comparison = Json::parse(compared.out);
  CHECK(comparison["schemes"].size() == 2);
  CHECK(comparison["config_differences"].size() == 3);
  for (const std::string id : {"lee2007", "peercy1997"}) {
    INFO(id);
    const Outcome run = bumpsim("run scene.toml --json --out " + id + " --scheme " + id + settings, folder.path());
    REQUIRE(run.code == 0);
    Json alone = Json::parse(run.out);
    CHECK(alone["scene"] == comparison["scene"]);
    CHECK(alone["inputs"] == comparison["inputs"]);
    CHECK(alone["config"] == comparison["config"]);
    const Json& together = scheme_in(comparison, id);
    CHECK(alone["scheme"]["provenance"] == together["provenance"]);
    for (const char* shared : {"schema", "schema_version", "status", "scene", "scheme", "engine", "inputs", "config", "host"})
      alone.erase(shared);
    CHECK(alone == together["result"]);
    CHECK(together["metrics"]["cycles"] == alone["cycles"]);
    CHECK(together["metrics"]["psnr_hardware_to_reference_db"] == alone["quality"]["against_reference"]["psnr_db"]);
  }
  CHECK(scheme_in(comparison, "lee2007")["metrics"]["conversion_tables"].is_number());
  CHECK(scheme_in(comparison, "peercy1997")["metrics"]["conversion_tables"].is_null());
}

TEST_CASE("the folder holds the same bytes for any number of jobs, any folder, and again") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  fs::create_directory(folder.path() / "elsewhere");
  REQUIRE(bumpsim("compare scene.toml --out one --jobs 1", folder.path()).code == 0);
  REQUIRE(bumpsim("compare ../scene.toml --out two --jobs 2 --schemes all", folder.path() / "elsewhere").code == 0);
  REQUIRE(bumpsim("compare scene.toml --out seven --jobs 7", folder.path()).code == 0);
  for (const std::string& file : files) {
    INFO(file);
    const std::string bytes = read_file(folder.path() / "one" / file);
    CHECK_FALSE(bytes.empty());
    CHECK((bytes == read_file(folder.path() / "elsewhere/two" / file)));
    CHECK((bytes == read_file(folder.path() / "seven" / file)));
  }
  CHECK(std::distance(fs::directory_iterator(folder.path() / "one"), {}) == static_cast<std::ptrdiff_t>(files.size()));
}

TEST_CASE("stdout and the folder hold the same tables") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const std::string command = "compare scene.toml --schemes phong1975,lee2007 --format ";
  const Outcome text = bumpsim(command + "text --out r", folder.path());
  REQUIRE(text.code == 0);
  CHECK(text.out.rfind(read_file(folder.path() / "r/compare.txt"), 0) == 0);
  CHECK(text.out.find("comparison in r") != std::string::npos);
  CHECK(bumpsim(command + "md", folder.path()).out == read_file(folder.path() / "r/compare.md"));
  CHECK(bumpsim(command + "csv", folder.path()).out == read_file(folder.path() / "r/compare.csv"));
  CHECK(bumpsim(command + "json", folder.path()).out == read_file(folder.path() / "r/compare.json"));
}

TEST_CASE("both engines compare alike") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  Json documents[2];
  for (const int i : {0, 1}) {
    const Outcome outcome = bumpsim(
        std::string("compare scene.toml --schemes lee2007,kim2001 --json --engine ") + (i == 0 ? "dated" : "stepped"), folder.path());
    REQUIRE(outcome.code == 0);
    documents[i] = Json::parse(outcome.out);
    documents[i].erase("engine");
  }
  CHECK(documents[0] == documents[1]);
}

TEST_CASE("a scheme that fails is a row with its reason, and decides the exit code") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const std::string broken = " --set kim2001.transform=direct --set kim2001.map_filter=vector";
  const Outcome alone = bumpsim("run scene.toml --scheme kim2001 --out r" + broken, folder.path());
  INFO(alone.err);
  REQUIRE(alone.code == 2);
  const Outcome compared = bumpsim("compare scene.toml --schemes kim2001,peercy1997 --out c --json" + broken, folder.path());
  INFO(compared.err);
  CHECK(compared.code == 2);
  CHECK(compared.err.find("bumpsim: kim2001: ") != std::string::npos);
  CHECK(compared.err.find("1 of 2 schemes failed") != std::string::npos);
  const Json comparison = Json::parse(compared.out);
  CHECK(comparison["status"] == "error");
  CHECK(scheme_in(comparison, "kim2001")["status"] == "error");
  CHECK(alone.err.find(scheme_in(comparison, "kim2001")["error"]["what"].get<std::string>()) != std::string::npos);
  CHECK(scheme_in(comparison, "peercy1997")["metrics"]["cycles"] > 0);
  CHECK(fs::exists(folder.path() / "c/compare.png"));
}

TEST_CASE("where every scheme fails nothing is written") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const Outcome outcome = bumpsim(
      "compare scene.toml --schemes lee2007,phong1975 --out c --set texture_fetch.batch=8 --set fifos.interpolators_to_texture_fetch=5",
      folder.path());
  INFO(outcome.err);
  CHECK(outcome.code == 3);
  CHECK(outcome.err.find("2 of 2 schemes failed; exit code 3") != std::string::npos);
  CHECK(outcome.err.find("texture_fetch waits for") != std::string::npos);
  CHECK(outcome.out.find("deadlock") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "c"));
}

TEST_CASE("wrong arguments of a comparison are explained and nothing is written") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const std::pair<const char*, const char*> cases[] = {
      {"compare", "scene"},
      {"compare nowhere.toml", "nowhere.toml"},
      {"compare scene.toml --schemes lee2008", "lee2007"},
      {"compare scene.toml --schemes ''", "without name"},
      {"compare scene.toml --schemes lee2007,,phong1975", "without name"},
      {"compare scene.toml --engine fast", "dated"},
      {"compare scene.toml --format html", "--format"},
      {"compare scene.toml --jobs -1", "--jobs"},
      {"compare scene.toml --jobs many", "--jobs"},
      {"compare scene.toml --set fifos.depht=2", "fifos.depth"},
      {"compare scene.toml --out ''", "--out"},
      {"compare scene.toml --out scene.toml", "in the way"},
      {"compare scene.toml --out /proc/comparison", "/proc"},
  };
  for (const auto& [arguments, says] : cases) {
    INFO(arguments);
    const Outcome outcome = bumpsim(arguments, folder.path());
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK(outcome.out.empty());
  }
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("only an earlier comparison is replaced, and only with --force") {
  const TemporaryFolder folder;
  folder.write("scene.toml", tiny_scene());
  const std::string compare = "compare scene.toml --schemes phong1975 --out ";
  REQUIRE(bumpsim(compare + "c", folder.path()).code == 0);
  CHECK(bumpsim(compare + "c", folder.path()).err.find("--force") != std::string::npos);
  CHECK(bumpsim(compare + "c --force --set numeric=double", folder.path()).code == 0);
  CHECK(read_file(folder.path() / "c/compare.txt").find("numeric = double") != std::string::npos);

  REQUIRE(bumpsim("run scene.toml --no-quality --out r", folder.path()).code == 0);
  CHECK(bumpsim(compare + "r --force", folder.path()).code == 2);
  CHECK(fs::exists(folder.path() / "r/result.json"));
  CHECK(bumpsim("run scene.toml --no-quality --force --out c", folder.path()).code == 2);
  folder.write("c/notes.txt", "precious");
  CHECK(bumpsim(compare + "c --force", folder.path()).err.find("notes.txt") != std::string::npos);
  CHECK(read_file(folder.path() / "c/notes.txt") == "precious");
}

TEST_CASE("what all schemes have to say is said once") {
  const TemporaryFolder folder;
  std::string scene = tiny_scene();
  const std::string target = "target = [0, 0, 0]";
  scene.replace(scene.find(target), target.size(), "target = [0, -99, 0]");  // looks away
  folder.write("scene.toml", scene);
  const Outcome outcome = bumpsim("compare scene.toml", folder.path());
  CHECK(outcome.code == 0);
  const auto first = outcome.err.find("nothing is seen");
  REQUIRE(first != std::string::npos);
  CHECK(outcome.err.find("nothing is seen", first + 1) == std::string::npos);
  CHECK(outcome.out.find(" nan") == std::string::npos);
}

namespace {

bool is_work_folder(const fs::path& folder) {
  for (const auto& process : fs::directory_iterator("/proc")) {
    std::error_code error;
    if (fs::read_symlink(process.path() / "cwd", error) == folder && !error) return true;
  }
  return false;
}

/// A process that was killed with its parent is gone a little later, since its memory is freed first. One that works on is not.
bool falls_idle(const fs::path& folder) {
  for (int tenths = 0; tenths < 300 && is_work_folder(folder); ++tenths) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return !is_work_folder(folder);
}

}  // namespace

TEST_CASE("an interrupted comparison leaves no folder and no process") {
  const TemporaryFolder folder;
  folder.write("scene.toml", "[frame]\nwidth = 2048\nheight = 2048\n" + small_scene().substr(small_scene().find("[camera]")));
  // One signal to the program, or one to it and one to its group: the second ends it at once.
  for (const std::string whom : {"--foreground", ""})
    for (const std::string signal : {"INT", "TERM"}) {
      const Outcome outcome = bumpsim("compare scene.toml --schemes lee2007,phong1975 --engine stepped --out c", folder.path(),
                                      "timeout --preserve-status " + whom + " -s " + signal + " 1");
      INFO(whom << " " << signal << ": " << outcome.err);
      CHECK(outcome.code == 130);
      CHECK(outcome.out.empty());
      CHECK(falls_idle(folder.path()));
      for (const auto& entry : fs::directory_iterator(folder.path())) CHECK(entry.path().filename() == "scene.toml");
    }
}
