// How the points of a sweep are named, gathered and split, and what its journal keeps.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "sweep_files.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/experiments/sweep_plan.h"
#include "testbench/experiments/sweep_run.h"

using namespace bump;

namespace {

const std::string heading = "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"kim2001\"]\n";

std::vector<std::string> ids_of(const SweepPlan& plan) {
  std::vector<std::string> ids;
  for (const PlannedPoint& point : plan.points()) ids.push_back(point.id);
  return ids;
}

std::vector<std::string> ids_of(const SweepFiles& files, const std::string& text, const std::string& version = "1") {
  return ids_of(SweepPlan(files.spec(text), version));
}

std::string line_of(const std::string& id) {
  return journal_line("{\"id\": \"" + id + "\", \"status\": \"ok\", \"reason\": null, \"values\": [], \"warnings\": []}");
}

}  // namespace

TEST_CASE("a point is named by what it is, not by how the specification says it") {
  const SweepFiles files;
  const auto ids = ids_of(files, heading + "[grid]\nfifos.depth = [2, 4]\nmemory.latency = [40, 50]\n");
  CHECK(std::set<std::string>(ids.begin(), ids.end()).size() == 8);
  const std::string lists =
      "[[list]]\nfifos.depth = 2\n[[list]]\nfifos.depth = 2\nmemory.latency = 50\n[[list]]\nmemory.latency = 40\n[[list]]\nmemory.latency "
      "= "
      "50\n";
  CHECK(ids == ids_of(files, heading + "[base]\nframe.width = 32\n" + lists));
  files.write("deep.toml", "[fifos]\ndepth = 4\n");
  CHECK(ids == ids_of(files, heading + "config = \"deep.toml\"\n" + lists));
}

TEST_CASE("whatever a result depends on changes the names") {
  const SweepFiles files;
  const std::string text = heading + "[grid]\nfifos.depth = [2, 4]\n";
  const auto ids = ids_of(files, text);
  const auto all_differ = [&](const std::vector<std::string>& others) {
    REQUIRE(others.size() == ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) CHECK(others[i] != ids[i]);
  };
  CHECK(ids_of(files, text) == ids);
  all_differ(ids_of(files, text, "2"));
  all_differ(ids_of(files, heading + "quality = false\n[grid]\nfifos.depth = [2, 4]\n"));
  all_differ(ids_of(files, text + "[base]\nmemory.latency = 41\n"));
  all_differ(ids_of(files, text + "[base]\nframe.height = 25\n"));
  files.write("ball.toml", SweepFiles::scene_text("sphere") + "# a remark\n");
  all_differ(ids_of(files, text));
}

TEST_CASE("points that differ in time and caches alone share a simulation") {
  const SweepFiles files;
  const SweepPlan plan(
      files.spec(heading + "[grid]\nfifos.depth = [1, 2, 3]\nmemory.latency = [7, 8]\ntexture_fetch.filter = [\"nearest\", "
                           "\"bilinear\"]\n[one_at_a_time]\ntexture_fetch.cache.sets = [2, 4, 8]\n"),
      "1");
  // Two schemes, two filters; the base of the factors is bilinear.
  REQUIRE(plan.groups().size() == 4);
  CHECK(plan.points().size() == 2 * (3 * 2 * 2 + 1 + 3));
  std::size_t members = 0;
  for (const PointGroup& group : plan.groups()) {
    members += group.members.size();
    const Configuration recorded = plan.recorded_configuration(group);
    CHECK(recorded.integer("fifos.depth") == 4);
    CHECK(recorded.integer("memory.latency") == 40);
    for (const std::size_t point : group.members) {
      CHECK(plan.configuration_of(point).choice("texture_fetch.filter") == recorded.choice("texture_fetch.filter"));
      CHECK(&plan.group_of(point) == &group);
    }
    CHECK(group.varies_caches == (recorded.choice("texture_fetch.filter") == "bilinear"));
  }
  CHECK(members == plan.points().size());
}

TEST_CASE("what one scheme alone declares makes no points of the others") {
  const SweepFiles files;
  const std::string both = "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"yp6\"]\n";
  const SweepPlan plan(files.spec(both + "[grid]\nyp6.word_bits = [9, 10, 11]\nfifos.depth = [1, 2]\n"), "1");
  std::size_t of_lee = 0, of_yp6 = 0;
  for (std::size_t i = 0; i < plan.points().size(); ++i) {
    const bool is_lee = plan.group_of(i).scheme->page().id == "lee2007";
    (is_lee ? of_lee : of_yp6) += 1;
    CHECK((plan.describe(i).find("yp6.word_bits") == std::string::npos) == is_lee);
    CHECK(plan.configuration_of(i).integer("yp6.word_bits") == (is_lee ? 12 : 9 + static_cast<int>(i - 2) / 2));
  }
  CHECK(of_lee == 2);
  CHECK(of_yp6 == 6);
  CHECK(plan.repeated() == 4);
  // Nor do they change the names: a point of lee2007 is the same whatever yp6 is set to.
  const auto plain = ids_of(files, both + "[grid]\nfifos.depth = [1, 2]\n");
  CHECK(plan.points()[0].id == plain[0]);
  CHECK(plan.points()[1].id == plain[1]);
  const auto based = ids_of(files, both + "[base]\nyp6.ports = 2\n[grid]\nfifos.depth = [1, 2]\n");
  CHECK(based[0] == plain[0]);
  CHECK(based[2] != plain[2]);
  CHECK_THROWS_WITH(files.spec(heading + "[grid]\nyp6.word_bits = [9, 10]\n"), Catch::Contains("no point of the sweep has a scheme"));
}

TEST_CASE("points that are the same are kept once") {
  const SweepFiles files;
  const SweepPlan plan(files.spec(heading + "[grid]\nfifos.depth = [1, 4]\n[one_at_a_time]\nfifos.depth = [4, 5]\nframe.width = 32\n"),
                       "1");
  CHECK(plan.points().size() == 2 * 3);
  CHECK(plan.repeated() == 2 * 3);
}

TEST_CASE("shards split the points and nothing else; groups stay whole where there are enough") {
  const SweepFiles files;
  const SweepPlan plan(
      files.spec("scenes = [\"ball.toml\", \"wall.toml\"]\nschemes = \"all\"\n[grid]\nfifos.depth = [1, 2, 3]\nmemory.latency = [5, 6]\n"),
      "1");
  const int groups = static_cast<int>(plan.groups().size());
  for (const int of : {1, 2, 3, 7, groups, groups + 1, 1000}) {
    std::map<std::size_t, std::set<int>> shards_of_group;
    for (std::size_t point = 0; point < plan.points().size(); ++point) {
      int shards = 0;
      for (int index = 1; index <= of; ++index) {
        if (!plan.is_in({index, of}, point)) continue;
        ++shards;
        shards_of_group[plan.points()[point].group].insert(index);
      }
      CHECK(shards == 1);
    }
    for (const auto& [group, shards] : shards_of_group)
      if (of <= groups) CHECK(shards.size() == 1);
  }
}

TEST_CASE("shards and shares are read strictly") {
  CHECK(shard_of("2/3").index == 2);
  CHECK(shard_of("2/3").of == 3);
  for (const std::string text : {"", "2", "0/3", "4/3", "1/0", "-1/3", "1/3 ", "1/3/4", "a/b", "1/", "/2", "1.5/2"})
    CHECK_THROWS_AS(shard_of(text), Error);
  CHECK(check_share_of("5%").is_percent);
  CHECK(check_share_of("5%").value == 5);
  CHECK(check_share_of("all").value == 100);
  CHECK(check_share_of("0").value == 0);
  for (const std::string text : {"", "%", "-1", "1.5", "101%", "nan", "some", "3 ", "inf"}) CHECK_THROWS_AS(check_share_of(text), Error);
}

TEST_CASE("a journal keeps whole lines, whatever a process that was killed has left") {
  const SweepFiles files;
  const std::string folder = files.path("out"), file = "out/" + std::string(SweepJournal::file_name);
  {
    SweepJournal journal(folder, false);
    journal.append(line_of("a") + line_of("b"));
    CHECK_FALSE(journal.has("a"));
    journal.refresh();
    CHECK(journal.has("a"));
    CHECK(journal.point("b")["id"] == "b");
  }
  const std::string whole = files.read(file);
  // Cut off anywhere, it opens, keeps what was whole, and takes more.
  for (std::size_t size = 0; size < whole.size(); ++size) {
    files.write(file, whole.substr(0, size));
    {
      SweepJournal journal(folder, false);
      CHECK(journal.has("a") == (size >= whole.find("\n{\"id\": \"b\"") + 1));
      CHECK_FALSE(journal.has("b"));
      journal.append(line_of("c"));
    }
    SweepJournal journal(folder, false);
    CHECK(journal.has("c"));
    CHECK(journal.point("c")["status"] == "ok");
  }
  files.write(file, whole + "{\"id\": \"c\", \"stat" + std::string(40, '\0'));
  SweepJournal journal(folder, false);
  CHECK(journal.has("b"));
  CHECK_FALSE(journal.has("c"));
}

TEST_CASE("a line that is torn or changed does not count, and is named") {
  const SweepFiles files;
  const std::string folder = files.path("out"), file = std::string("out/") + SweepJournal::file_name;
  SweepJournal(folder, false).append(line_of("a") + line_of("b") + line_of("c"));
  CHECK(SweepJournal(folder, false).damages().empty());
  const std::string whole = files.read(file), b = line_of("b");
  const std::size_t at = whole.find(b);
  REQUIRE(at != std::string::npos);
  for (std::size_t i = 0; i + 1 < b.size(); ++i) {
    std::string changed = whole;
    changed[at + i] = changed[at + i] == '0' ? '1' : '0';
    files.write(file, changed);
    const SweepJournal journal(folder, false);
    INFO("character " << i << " of " << b);
    CHECK(journal.has("a"));
    CHECK_FALSE(journal.has("b"));
    CHECK(journal.has("c"));
    REQUIRE(journal.damages().size() == 1);
    CHECK_THAT(journal.damages().front(), Catch::Contains(SweepJournal::file_name) && Catch::Contains("line 4, is damaged"));
  }
  // Cut off anywhere in its last line, it has all but that.
  for (std::size_t size = whole.find(line_of("c")) + 1; size < whole.size() - 1; ++size) {
    files.write(file, whole.substr(0, size));
    const SweepJournal journal(folder, false);
    CHECK(journal.has("b"));
    CHECK_FALSE(journal.has("c"));
    CHECK(journal.damages().size() == 1);
  }
  files.write(file, "{\"journal\": \"bumpsim-sweep\", \"version\": 1}\n\n{\"id\": \"a\"}\n");
  CHECK_THROWS_WITH(SweepJournal(folder, false), Catch::Contains("another version"));
  CHECK_FALSE(SweepJournal(folder, true).has("a"));
}

TEST_CASE("several processes append to one journal") {
  const SweepFiles files;
  SweepJournal journal(files.path("out"), false);
  std::vector<ChildTask> tasks;
  for (int task = 0; task < 6; ++task)
    tasks.push_back({"writer", [&journal, task](const ReportShare&) {
                       for (int i = 0; i < 20; ++i)
                         journal.append(line_of(std::to_string(task) + "-" + std::to_string(i) + std::string(3000, 'x')));
                       return std::string();
                     }});
  ChildOptions options;
  options.jobs = 6;
  for (const ChildOutcome& outcome : run_in_children(tasks, options)) CHECK_FALSE(outcome.error);
  journal.refresh();
  for (int task = 0; task < 6; ++task)
    for (int i = 0; i < 20; ++i) CHECK(journal.has(std::to_string(task) + "-" + std::to_string(i) + std::string(3000, 'x')));
}

TEST_CASE("a journal is begun anew when asked, and only where it may be") {
  const SweepFiles files;
  SweepJournal(files.path("out"), false).append(line_of("a") + journal_line("{\"checked\": \"a\"}"));
  CHECK(SweepJournal(files.path("out"), false).is_checked("a"));
  CHECK_FALSE(SweepJournal(files.path("out"), true).has("a"));
  CHECK_FALSE(SweepJournal(files.path("out"), false).has("a"));
  CHECK_THROWS_WITH(SweepJournal(files.folder().string(), false), Catch::Contains("in use"));
  CHECK_THROWS_WITH(SweepJournal(files.path("ball.toml"), false), Catch::Contains("in the way"));
  CHECK_THROWS_WITH(SweepJournal("", false), Catch::Contains("no name"));
  std::filesystem::create_directory(files.folder() / "other");
  files.write("other/" + std::string(SweepJournal::file_name), "the diary of a user\n");
  CHECK_THROWS_WITH(SweepJournal(files.path("other"), true), Catch::Contains("in use"));
  CHECK(files.read("other/" + std::string(SweepJournal::file_name)) == "the diary of a user\n");
}
