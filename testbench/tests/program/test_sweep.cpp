// `bumpsim sweep` and `bumpsim merge` as a user meets them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "program_runner.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/program/version.h"

using namespace bump;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> tables = {"points.csv", "points.jsonl", "sweep.json"};

std::string tiny_scene(const std::string& shape = "sphere") {
  return "[frame]\nwidth = 40\nheight = 32\n[camera]\neye = [0, 0, 3]\n[[light]]\ndirection = [0.3, 0.4, 1]\n[[object]]\nshape = \"" +
         shape + "\"\ntessellation = 8\n";
}

/// Two groups of a scheme that are dated again, single runs, a deadlock and a bad combination.
const std::string mixed_spec = R"(scenes = ["ball.toml", "wall.toml"]
schemes = ["lee2007", "kugler1998"]
[base]
frame.width = 36
[grid]
fifos.depth = [1, 4]
memory.latency = [5, 100]
texture_fetch.cache.line_bytes = [32, 64]
[one_at_a_time]
numeric = "double"
environment.multipliers = [1, 2]
clock.megahertz = 250
light_map_fetch.cache.sets = [2, 3]
[[list]]
texture_fetch.batch = 8
fifos.interpolators_to_texture_fetch = 4
[[list]]
scheme = "kim2001"
kim2001.transform = "direct"
kim2001.map_filter = "vector"
)";

TemporaryFolder& with_scenes(TemporaryFolder& folder) {
  folder.write("ball.toml", tiny_scene());
  folder.write("wall.toml", tiny_scene("plane"));
  return folder;
}

std::vector<Json> rows_of(const fs::path& folder) {
  std::vector<Json> rows;
  std::istringstream lines(read_file(folder / "points.jsonl"));
  for (std::string line; std::getline(lines, line);) rows.push_back(Json::parse(line));
  return rows;
}

/// What the summary counts under a name; 0 where it does not.
int counted(const Outcome& outcome, const std::string& name) {
  const auto at = outcome.out.find("  " + name + " ");
  return at == std::string::npos ? 0 : std::stoi(outcome.out.substr(at + 2 + name.size()));
}

void check_same_tables(const fs::path& a, const fs::path& b) {
  for (const std::string& table : tables) {
    INFO(table << " of " << a << " and " << b);
    CHECK_FALSE(read_file(a / table).empty());
    CHECK((read_file(a / table) == read_file(b / table)));
  }
}

std::size_t finished_points(const fs::path& journal) {
  std::size_t count = 0;
  std::istringstream lines(read_file(journal));
  for (std::string line; std::getline(lines, line);) count += Json::accept(line) && Json::parse(line).contains("id") ? 1U : 0U;
  return count;
}

}  // namespace

TEST_CASE("the tables have the same bytes for any number of jobs, any folder and any sharding") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", mixed_spec);
  fs::create_directory(folder.path() / "elsewhere");
  const Outcome one = bumpsim("sweep spec.toml --out one --jobs 1", folder.path());
  INFO(one.err);
  REQUIRE(one.code == 0);
  CHECK(bumpsim("sweep ../spec.toml --out five --jobs 5 --check 0", folder.path() / "elsewhere").code == 0);
  check_same_tables(folder.path() / "one", folder.path() / "elsewhere/five");
  for (const int of : {2, 9, 40}) {
    std::string shards;
    for (int index = 1; index <= of; ++index) {
      const std::string name = "s" + std::to_string(index) + "of" + std::to_string(of);
      const Outcome shard = bumpsim(
          "sweep spec.toml --check 0 --out " + name + " --shard " + std::to_string(index) + "/" + std::to_string(of), folder.path());
      INFO(shard.err);
      CHECK((shard.code == 0 || shard.code == 2 || shard.code == 3));  // of a shard, all points may fail
      shards = name + " " + shards;
      if (of == 40 && index == 3) break;  // what one of many shards holds is enough
    }
    const std::string merged = "m" + std::to_string(of);
    const Outcome merge = bumpsim("merge " + shards + " --out " + merged, folder.path());
    INFO(merge.err);
    CHECK(merge.code == (of == 40 ? 2 : 0));
    if (of == 40) {
      CHECK(merge.err.find("missing") != std::string::npos);
      CHECK_FALSE(fs::exists(folder.path() / merged));
    } else {
      check_same_tables(folder.path() / "one", folder.path() / merged);
      // It goes on as any sweep does.
      const Outcome again = bumpsim("sweep spec.toml --check 0 --out " + merged, folder.path());
      CHECK(counted(again, "simulations") == 0);
      check_same_tables(folder.path() / "one", folder.path() / merged);
    }
  }
}

TEST_CASE("every row says what a run of its point says, whether it was simulated or dated again") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", mixed_spec);
  const Outcome swept = bumpsim("sweep spec.toml --out s --check 8", folder.path());
  INFO(swept.err);
  REQUIRE(swept.code == 0);
  CHECK(counted(swept, "checked by full runs") == 8);
  CHECK(counted(swept, "dated from their traces") > 40);
  // The scene as the specification has it, by its own file.
  std::string scene = tiny_scene();
  scene.replace(scene.find("width = 40"), 10, "width = 36");
  folder.write("ball36.toml", scene);
  const Json manifest = Json::parse(read_file(folder.path() / "s/sweep.json"));
  std::map<std::string, int> statuses;
  int compared = 0;
  for (const Json& row : rows_of(folder.path() / "s")) {
    ++statuses[row["status"].get<std::string>()];
    CHECK(row["reason"].is_null() == (row["status"] == "ok"));
    CHECK(row["cycles"].is_null() == (row["status"] != "ok"));
    if (row["scene"] != "ball.toml" || row["point"].get<int>() % 7 != 2) continue;
    std::string settings;
    for (const auto& key : manifest["parameters"]) {
      const Json& value = row[key.get<std::string>()];
      if (value.is_null()) continue;  // another scheme's
      settings += " --set " + key.get<std::string>() + "=" + (value.is_string() ? value.get<std::string>() : value.dump());
    }
    const Outcome run =
        bumpsim("run ball36.toml --json --out r --force --scheme " + row["scheme"].get<std::string>() + settings, folder.path());
    INFO(row.dump() << "\n" << run.err);
    const Json result = Json::parse(run.out);
    CHECK(result["status"] == row["status"]);
    if (row["status"] != "ok") continue;
    ++compared;
    CHECK(result["cycles"] == row["cycles"]);
    CHECK(result["fragments_per_cycle"] == row["fragments_per_cycle"]);
    CHECK(result["bound"]["by"] == row["bound_by"]);
    CHECK(result["frames_per_second"] == row["frames_per_second"]);
    CHECK(result["texture"]["bytes"].get<double>() / 1024 == row["texture_kilobytes"].get<double>());
    CHECK(result["operators"]["environment"]["built"]["multipliers"] == row["environment_multipliers"]);
    CHECK(result["quality"]["against_reference"]["psnr_db"] == row["psnr_hardware_to_reference_db"]);
    CHECK(result["quality"]["against_reference"]["max_error"] == row["max_error_steps_of_255"]);
    const Json& own = result["operators"]["environment"]["multipliers_after_sharing"];
    CHECK(own.get<int>() <= row["multipliers_after_sharing"].get<int>());
  }
  CHECK(compared > 3);
  CHECK(statuses["deadlock"] == 4);
  CHECK(statuses["error"] >= 2 + 2);  // the combination, and sets that are no power of two
  CHECK(manifest["statuses"] == Json(statuses));
}

TEST_CASE("CSV and JSON Lines hold the same") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = \"all\"\n[grid]\nfifos.depth = [1, 2]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s --check 0", folder.path()).code == 0);
  std::istringstream csv(read_file(folder.path() / "s/points.csv"));
  std::string line;
  std::getline(csv, line);
  const auto rows = rows_of(folder.path() / "s");
  std::size_t fields = 1;
  fields += static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
  CHECK(fields == rows.front().size());
  for (const char* name : {"point", "id", "scene", "scheme", "frame.width", "fifos.depth", "status", "cycles", "built_multipliers",
                           "table_bits", "texture_kilobytes", "psnr_hardware_to_reference_db", "reason"}) {
    CHECK(("," + line + ",").find(std::string(",") + name + ",") != std::string::npos);
    CHECK(rows.front().contains(name));
  }
  std::size_t lines = 0;
  while (std::getline(csv, line)) ++lines;
  CHECK(lines == rows.size());
}

TEST_CASE("only points that changed run again") {
  TemporaryFolder folder;
  with_scenes(folder);
  const auto spec = [&](const std::string& latencies, const std::string& filters, const std::string& base = "") {
    folder.write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n[base]\n" + base +
                                  "[grid]\nmemory.latency = " + latencies + "\ntexture_fetch.filter = " + filters + "\n");
    return bumpsim("sweep spec.toml --out s", folder.path());
  };
  const Outcome first = spec("[5, 50]", "[\"nearest\", \"bilinear\"]");
  REQUIRE(first.code == 0);
  CHECK(counted(first, "finished before") == 0);
  CHECK(counted(first, "simulations") == 2);
  CHECK(counted(first, "dated from their traces") == 4);
  const std::string bytes = read_file(folder.path() / "s/points.csv");

  const Outcome same = spec("[5, 50]", "[\"nearest\", \"bilinear\"]");
  CHECK(counted(same, "finished before") == 4);
  CHECK(counted(same, "simulations") + counted(same, "checked by full runs") == 0);
  CHECK((read_file(folder.path() / "s/points.csv") == bytes));

  const Outcome more = spec("[5, 20, 50]", "[\"bilinear\", \"trilinear\"]");
  CHECK(counted(more, "finished before") == 2);
  CHECK(counted(more, "simulations") == 2);
  CHECK(counted(more, "dated from their traces") == 4);
  CHECK(rows_of(folder.path() / "s").size() == 6);

  const Outcome other = spec("[5, 50]", "[\"nearest\", \"bilinear\"]", "memory.outstanding = 2\n");
  CHECK(counted(other, "finished before") == 0);
  const Outcome back = spec("[5, 50]", "[\"nearest\", \"bilinear\"]");
  CHECK(counted(back, "finished before") == 4);
  CHECK((read_file(folder.path() / "s/points.csv") == bytes));

  folder.write("ball.toml", tiny_scene() + "# moved\n");
  CHECK(counted(spec("[5, 50]", "[\"nearest\", \"bilinear\"]"), "finished before") == 0);
  const Outcome forced = bumpsim("sweep spec.toml --out s --force", folder.path());
  CHECK(counted(forced, "simulations") == 2);
}

TEST_CASE("a killed sweep loses at most the points in flight, and goes on where it stopped") {
  TemporaryFolder folder;
  with_scenes(folder).write(
      "spec.toml",
      "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"phong1975\"]\n[base]\nframe.width = 200\nframe.height = 200\n"
      "[grid]\ntexture_fetch.filter = [\"nearest\", \"bilinear\", \"trilinear\"]\n"
      "numeric = [\"fixed\", \"double\"]\nmemory.latency = [5, 6]\n");
  REQUIRE(bumpsim("sweep spec.toml --out whole --check 0", folder.path()).code == 0);
  const fs::path journal = folder.path() / "s/journal.jsonl";
  std::size_t before = 0;
  for (const int stop_after : {1, 4, 6}) {
    // Ends the sweep with SIGKILL as soon as so many lines more are in the journal, while others are being worked on.
    const std::string lines = std::to_string(before + static_cast<std::size_t>(stop_after));
    folder.write("kill.sh", R"("$@" & pid=$!
while kill -0 $pid 2>/dev/null; do
  n=$(grep -c '"id"' s/journal.jsonl 2>/dev/null)
  [ "${n:-0}" -lt )" + lines + R"( ] || break
done
kill -9 $pid 2>/dev/null
wait $pid
)");
    const Outcome killed = bumpsim("sweep spec.toml --out s --check 0 --jobs 2", folder.path(), "bash kill.sh");
    const std::size_t now = finished_points(journal);
    INFO(killed.code << " " << killed.err);
    if (killed.code == 0 && before > 0) break;  // it was through before the signal came
    CHECK(killed.code == 137);
    CHECK(now >= before + static_cast<std::size_t>(stop_after));
    for (const std::string& table : tables) CHECK_FALSE(fs::exists(folder.path() / "s" / table));
    before = now;
  }
  const Outcome resumed = bumpsim("sweep spec.toml --out s --check 0", folder.path());
  INFO(resumed.err);
  REQUIRE(resumed.code == 0);
  CHECK(counted(resumed, "finished before") >= static_cast<int>(before));
  check_same_tables(folder.path() / "whole", folder.path() / "s");
}

TEST_CASE("an interrupted sweep says what is finished, and one folder has one sweep at a time") {
  TemporaryFolder folder;
  with_scenes(folder).write(
      "spec.toml",
      "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"kim2001\"]\n[base]\nframe.width = 2000\nframe.height = 2000\n"
      "[grid]\ntexture_fetch.filter = [\"nearest\", \"bilinear\", \"trilinear\"]\n");
  // A second sweep comes while the first one works, which is interrupted afterwards.
  folder.write("stop.sh", "\"$@\" & pid=$!\nwhile [ ! -s s/journal.jsonl ]; do :; done\n'" BUMP_PROGRAM
                          "' sweep spec.toml --out s 2>second\necho $? >>second\nkill -TERM $pid\nwait $pid\n");
  const Outcome stopped = bumpsim("sweep spec.toml --out s --jobs 2", folder.path(), "bash stop.sh");
  INFO(stopped.err);
  CHECK(stopped.code == 130);
  CHECK(stopped.err.find("of 6 points are finished") != std::string::npos);
  CHECK(stopped.err.find("the same command") != std::string::npos);
  const std::string second = read_file(folder.path() / "second");
  INFO(second);
  CHECK(second.find("another sweep works in the output folder") != std::string::npos);
  CHECK(second.find("\n2\n") != std::string::npos);
  for (const auto& entry : fs::directory_iterator(folder.path() / "s")) CHECK(entry.path().filename() == "journal.jsonl");
}

TEST_CASE("a point that was dated wrongly ends the sweep with exit code 4 and its name") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n[grid]\nmemory.latency = [5, 50, 500]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s --check 0", folder.path()).code == 0);
  const auto rows = rows_of(folder.path() / "s");
  std::string journal = read_file(folder.path() / "s/journal.jsonl");
  const std::string cycles = "\"values\":[" + rows[1]["cycles"].dump() + ",";
  const auto at = journal.find(cycles, journal.find(rows[1]["id"].get<std::string>()));
  REQUIRE(at != std::string::npos);
  // A line that its sum does not give away, as a fault of the program would leave it.
  journal.replace(at, cycles.size(), "\"values\":[7,");
  const std::size_t sum = journal.find(",\"sum\"", at), begin = journal.rfind('\n', at) + 1, end = journal.find('\n', at);
  journal.replace(begin, end + 1 - begin, journal_line(journal.substr(begin, sum - begin) + "}"));
  folder.write("s/journal.jsonl", journal);
  const Outcome checked = bumpsim("sweep spec.toml --out s --check all", folder.path());
  INFO(checked.err);
  CHECK(checked.code == 4);
  CHECK(checked.err.find("point 1 (lee2007 on ball.toml, memory.latency = 50)") != std::string::npos);
  CHECK(checked.err.find("cycles is 7, and " + rows[1]["cycles"].dump()) != std::string::npos);
  for (const std::string& table : tables) CHECK_FALSE(fs::exists(folder.path() / "s" / table));
}

TEST_CASE("a changed line of the journal is named, and its point runs again") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n[grid]\nmemory.latency = [5, 50, 500]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s", folder.path()).code == 0);
  const std::string rows = read_file(folder.path() / "s/points.csv");
  std::string journal = read_file(folder.path() / "s/journal.jsonl");
  const std::size_t at = journal.find("\"values\":[");
  REQUIRE(at != std::string::npos);
  journal[at + 11] = journal[at + 11] == '9' ? '8' : '9';
  folder.write("s/journal.jsonl", journal);
  const Outcome again = bumpsim("sweep spec.toml --out s", folder.path());
  INFO(again.err);
  CHECK(again.code == 0);
  CHECK(again.err.find("journal.jsonl, line ") != std::string::npos);
  CHECK(again.err.find("is damaged: what it was about ran again") != std::string::npos);
  CHECK(counted(again, "finished before") == 2);
  CHECK((read_file(folder.path() / "s/points.csv") == rows));
}

TEST_CASE("a shard does not replace the tables of a whole sweep, or of another shard") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml",
                            "scenes = [\"ball.toml\"]\nschemes = [\"phong1975\"]\nquality = false\n[grid]\nfifos.depth = [1, 2, 4]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s", folder.path()).code == 0);
  const std::string rows = read_file(folder.path() / "s/points.csv");
  const Outcome shard = bumpsim("sweep spec.toml --out s --shard 1/3", folder.path());
  CHECK(shard.code == 2);
  CHECK(shard.err.find("the output folder holds a whole sweep, finished") != std::string::npos);
  CHECK(shard.err.find("--force") != std::string::npos);
  CHECK((read_file(folder.path() / "s/points.csv") == rows));
  REQUIRE(bumpsim("sweep spec.toml --out part --shard 1/3", folder.path()).code == 0);
  CHECK(bumpsim("sweep spec.toml --out part --shard 1/3", folder.path()).code == 0);
  CHECK(bumpsim("sweep spec.toml --out part --shard 2/3", folder.path()).err.find("holds shard 1/3, finished") != std::string::npos);
  CHECK(bumpsim("sweep spec.toml --out part --shard 2/3 --force", folder.path()).code == 0);
  // The whole has the rows of the part, too.
  CHECK(bumpsim("sweep spec.toml --out part", folder.path()).code == 0);
  CHECK((read_file(folder.path() / "part/points.csv") == rows));
}

TEST_CASE("a parameter of one scheme makes no rows of another, and is empty there") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml",
                            "scenes = [\"ball.toml\"]\nschemes = [\"phong1975\", \"yp6\"]\nquality = false\n[grid]\nyp6.ports = [1, 2]\n");
  const Outcome swept = bumpsim("sweep spec.toml --out s", folder.path());
  INFO(swept.err);
  REQUIRE(swept.code == 0);
  const std::vector<Json> rows = rows_of(folder.path() / "s");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["yp6.ports"].is_null());
  CHECK(rows[1]["yp6.ports"] == 1);
  CHECK(rows[2]["yp6.ports"] == 2);
  // Bits mean the same here, in a price and in Table 1: stored once.
  CHECK(rows[2]["table_bits"] < rows[1]["table_bits"]);
  for (const std::size_t i : {1U, 2U}) {
    const std::string setting = " --set yp6.ports=" + rows[i]["yp6.ports"].dump();
    const Json price = Json::parse(bumpsim("price yp6 --json" + setting, folder.path()).out);
    CHECK(price["schemes"][0]["table_bits"] == rows[i]["table_bits"]);
  }
}

TEST_CASE("what a run would warn of stands in the row and in the result") {
  TemporaryFolder folder;
  std::string aside = tiny_scene();  // seen along the z axis, the camera's axes are the object's
  aside.replace(aside.find("eye = [0, 0, 3]"), 15, "eye = [2, -2, 1]");
  folder.write("ball.toml", aside);
  folder.write("spec.toml",
               "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"yp6\"]\nquality = false\n[grid]\nvertex_processor.space = "
               "[\"object\", \"eye\"]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s", folder.path()).code == 0);
  for (const Json& row : rows_of(folder.path() / "s")) {
    INFO(row.dump());
    const bool is_off = row["scheme"] == "yp6" && row["vertex_processor.space"] == "eye";
    REQUIRE(row["warnings"].is_null() != is_off);
    const Outcome run = bumpsim("run ball.toml --no-quality --json --out r --force --scheme " + row["scheme"].get<std::string>() +
                                    " --set vertex_processor.space=" + row["vertex_processor.space"].get<std::string>(),
                                folder.path());
    const Json result = Json::parse(run.out);
    REQUIRE(result["warnings"].size() == (is_off ? 1 : 0));
    CHECK((run.err.find("does not fit yp6.frame=parallel along the camera's axes") != std::string::npos) == is_off);
    if (is_off) CHECK(result["warnings"][0] == row["warnings"]);
  }
}

TEST_CASE("the manifest says from which models the rows are") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = [\"phong1975\"]\nquality = false\n");
  REQUIRE(bumpsim("sweep spec.toml --out s", folder.path()).code == 0);
  const std::string version = Json::parse(read_file(folder.path() / "s/sweep.json"))["version"];
  CHECK(version == version_text() + ", models " + models_digest());
  CHECK(models_digest().size() == 16);
  CHECK(models_digest().find_first_not_of("0123456789abcdef") == std::string::npos);
}

TEST_CASE("the digest of the models follows their sources, not where they are") {
  TemporaryFolder folder;
  const fs::path tools = fs::path(BUMP_SOURCE_DIR) / "testbench/program";
  const auto digest = [&](const std::string& root) {
    const std::string output = (folder.path() / "digest.cpp").string();
    const std::string command = "cmake -DROOT='" + (folder.path() / root).string() + "' -DOUTPUT='" + output + "' -P '" +
                                (tools / "source_digest.cmake").string() + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    const std::string text = read_file(output);
    return text.substr(text.find("return \"") + 8, 16);
  };
  for (const char* root : {"a", "b"}) {
    fs::create_directories(folder.path() / root / "sc_models/units");
    fs::create_directories(folder.path() / root / "sc_models/schemes/new");
    folder.write(std::string(root) + "/sc_models/units/cache.cpp", "int ways = 4;\n");
  }
  const std::string first = digest("a");
  CHECK(digest("b") == first);
  folder.write("b/sc_models/schemes/new/test_new.cpp", "a test decides nothing\n");
  CHECK(digest("b") == first);
  folder.write("b/sc_models/schemes/new/new.cpp", "int bits = 8;\n");
  const std::string added = digest("b");
  CHECK(added != first);
  folder.write("b/sc_models/schemes/new/new.cpp", "int bits = 9;\n");
  CHECK(digest("b") != added);
}

TEST_CASE("where every point fails the exit code says so, and the rows are there") {
  TemporaryFolder folder;
  with_scenes(folder).write("stuck.toml",
                            "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n[grid]\ntexture_fetch.batch = 8\n"
                            "fifos.interpolators_to_texture_fetch = [4, 5]\n");
  const Outcome stuck = bumpsim("sweep stuck.toml --out stuck", folder.path());
  CHECK(stuck.code == 3);
  CHECK(stuck.err.find("2 of 2 points failed") != std::string::npos);
  for (const Json& row : rows_of(folder.path() / "stuck"))
    CHECK(row["reason"].get<std::string>().find("texture_fetch waits") != std::string::npos);

  folder.write("bad.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\nquality = false\n[grid]\ntexture_fetch.cache.sets = 3\n");
  CHECK(bumpsim("sweep bad.toml --out bad", folder.path()).code == 2);
  CHECK(rows_of(folder.path() / "bad").front()["reason"].get<std::string>().find("power of two") != std::string::npos);
}

TEST_CASE("without quality there are no references and no ratios") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml",
                            "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\nquality = false\n[grid]\nfifos.depth = [1, 2]\n");
  REQUIRE(bumpsim("sweep spec.toml --out s --check all", folder.path()).code == 0);
  for (const Json& row : rows_of(folder.path() / "s")) {
    CHECK(row["cycles"] > 0);
    CHECK(row["psnr_hardware_to_reference_db"].is_null());
  }
}

TEST_CASE("shards of other sweeps, and folders that are none, are not merged") {
  TemporaryFolder folder;
  const auto spec = [](const std::string& depths) {
    return "scenes = [\"ball.toml\"]\nschemes = [\"phong1975\"]\nquality = false\n[grid]\nnumeric = [\"fixed\", \"double\"]\nfifos.depth "
           "= " +
           depths + "\n";
  };
  with_scenes(folder).write("a.toml", spec("[1, 2]"));
  folder.write("b.toml", spec("[1, 3]"));
  const auto must = [&](const std::string& command) { REQUIRE(bumpsim(command, folder.path()).code == 0); };
  must("sweep a.toml --out a1 --shard 1/2");
  must("sweep a.toml --out a2 --shard 2/2");
  must("sweep b.toml --out b2 --shard 2/2");
  fs::create_directory(folder.path() / "empty");
  fs::copy(folder.path() / "a2", folder.path() / "cut", fs::copy_options::recursive);
  const std::string lines = read_file(folder.path() / "cut/points.jsonl");
  folder.write("cut/points.jsonl", lines.substr(0, lines.find('\n') + 1));
  fs::copy(folder.path() / "a2", folder.path() / "running", fs::copy_options::recursive);
  fs::remove(folder.path() / "running/sweep.json");
  const std::pair<const char*, const char*> cases[] = {
      {"merge a1 b2 --out m", "another sweep"},
      {"merge a1 --out m", "2 of 4 points are missing"},
      {"merge a1 a1 --out m", "2 of 4 points are missing"},
      {"merge a1 nowhere --out m", "no such folder"},
      {"merge a1 nowhere --out m", "why: what is merged are the folders"},
      {"merge a1 empty --out m", "no finished sweep"},
      {"merge a1 running --out m", "let the sweep finish"},
      {"merge a1 cut --out m", "incomplete"},
      {"merge a1 a2 --out a1 --force", "one of the shards"},
      {"merge a1 a2 --out b2", "--force"},
      {"merge a1 a2 --out empty/../..", "in use"},
      {"merge a1 a2", "--out"},
      {"merge --out m", "folders"},
  };
  for (const auto& [arguments, says] : cases) {
    INFO(arguments);
    const Outcome outcome = bumpsim(arguments, folder.path());
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "m"));
  }
  const Outcome twice = bumpsim("merge a1 a2 a1 ./a1 --out m", folder.path());
  CHECK(twice.code == 0);
  CHECK(twice.err.find("a1 is named more than once, and counts once") != std::string::npos);
  CHECK(twice.out.find("4 points of 2 folders") != std::string::npos);
  must("merge a1 a2 --out b2 --force");
  check_same_tables(folder.path() / "m", folder.path() / "b2");
}

TEST_CASE("wrong arguments of a sweep are explained and nothing is written") {
  TemporaryFolder folder;
  with_scenes(folder).write("spec.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n");
  folder.write("wrong.toml", "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n[grid]\nfifos.depht = [1, 2]\n");
  folder.write("broken.toml", "scenes = [\"none.toml\"]\nschemes = [\"lee2007\"]\n");
  folder.write("text.toml", "quality = \"no\"\nscenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n");
  const std::pair<const char*, const char*> cases[] = {
      {"sweep", "spec"},
      {"sweep spec.toml", "--out"},
      {"sweep nowhere.toml --out s", "nowhere.toml"},
      {"sweep wrong.toml --out s", "wrong.toml:4:7"},
      {"sweep wrong.toml --out s --json", "try: fifos.depth"},
      {"sweep broken.toml --out s", "broken.toml:1:11"},
      {"sweep text.toml --out s", "text.toml:1:11: quality is a text"},
      {"sweep spec.toml --out ''", "--out"},
      {"sweep spec.toml --out .", "in use"},
      {"sweep spec.toml --out spec.toml", "in the way"},
      {"sweep spec.toml --out /proc/sweep", "/proc"},
      {"sweep spec.toml --out s --shard 3/2", "no shard"},
      {"sweep spec.toml --out s --check many", "--check"},
      {"sweep spec.toml --out s --jobs -1", "--jobs"},
  };
  for (const auto& [arguments, says] : cases) {
    INFO(arguments);
    const Outcome outcome = bumpsim(arguments, folder.path());
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find(says) != std::string::npos);
    CHECK_FALSE(fs::exists(folder.path() / "s"));
  }
}

TEST_CASE("the example of the documentation runs, and says what the documentation says") {
  const TemporaryFolder folder;
  const fs::path experiments = fs::path(BUMP_SOURCE_DIR) / "testbench/experiments";
  const std::string spec = read_file(experiments / "sweep_example.toml"), page = read_file(experiments / "README.md");
  std::istringstream lines(spec);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK((line.empty() || page.find("    " + line + "\n") != std::string::npos));
  }
  const Outcome swept = bumpsim("sweep '" + (experiments / "sweep_example.toml").string() + "' --out s", folder.path());
  INFO(swept.err);
  REQUIRE(swept.code == 0);
  const auto said = page.find(swept.out.substr(0, swept.out.find('\n')));  // how many points it has
  CHECK(said != std::string::npos);
  for (const Json& row : rows_of(folder.path() / "s")) CHECK((row["status"] == "ok" || row["texture_fetch.batch"] == 8));
}
