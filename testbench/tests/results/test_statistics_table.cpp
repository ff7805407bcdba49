#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "sample_report.h"
#include "testbench/results/statistics_table.h"

using namespace bump;
using bump::made_up::Sample;

namespace {

/// Kind of module of a row, as the meanings name it.
std::string kind_of(const SimulationResult& result, const std::string& module) {
  for (const auto& stage : result.timing.stages)
    if (stage.name == module) return "stage";
  for (const auto& fifo : result.timing.fifos)
    if (fifo.name == module) return "fifo";
  for (const auto& memory : result.timing.memories)
    if (memory.name == module) return "memory";
  return module.substr(0, module.find('.'));
}

}  // namespace

TEST_CASE("every statistic has a unit and a meaning") {
  Sample sample;
  sample.result.light_maps = {{"diffuse", 1024, 16384, 2048, 2048, {250, 200, 50, 3200, 3}}};
  std::vector<StatisticMeaning> meanings = statistic_meanings();
  for (const StatisticMeaning& meaning : result_statistic_meanings()) meanings.push_back(meaning);
  const auto rows = statistic_rows(sample.report);
  CHECK(rows.size() > 100);
  for (const StatisticRow& row : rows) {
    INFO(row.module << " " << row.statistic);
    const std::string kind = kind_of(sample.result, row.module);
    const auto meaning = std::find_if(meanings.begin(), meanings.end(), [&](const StatisticMeaning& m) {
      const auto star = m.statistic.find('*');
      const bool same =
          star == std::string::npos ? m.statistic == row.statistic : row.statistic.compare(0, star, m.statistic, 0, star) == 0;
      return same && m.module_kind == kind;
    });
    REQUIRE(meaning != meanings.end());
    CHECK(meaning->unit == row.unit);
    CHECK_FALSE(meaning->meaning.empty());
  }
}

TEST_CASE("light maps have rows of their own, and a run without them none") {
  Sample sample;
  const auto rows_of_maps = [&] {
    std::vector<StatisticRow> found;
    for (const StatisticRow& row : statistic_rows(sample.report))
      if (row.module.rfind("light_map.", 0) == 0) found.push_back(row);
    return found;
  };
  CHECK(rows_of_maps().empty());
  sample.result.light_maps = {{"diffuse", 1024, 16384, 2048, 2048, {250, 200, 50, 3200, 3}}, {"specular", 1024, 16384, 2048, 2048, {}}};
  const auto rows = rows_of_maps();
  REQUIRE(rows.size() == 20);
  for (const StatisticRow& row : rows) {
    if (row.statistic == "hit_rate") CHECK(row.value == (row.module == "light_map.diffuse" ? "0.8" : ""));
    if (row.statistic == "clipped") CHECK(row.value == (row.module == "light_map.diffuse" ? "3" : "0"));
  }
}

TEST_CASE("no statistic appears twice") {
  const Sample sample;
  std::set<std::pair<std::string, std::string>> seen;
  for (const StatisticRow& row : statistic_rows(sample.report)) CHECK(seen.emplace(row.module, row.statistic).second);
}

TEST_CASE("values read back as the numbers they were") {
  Sample sample;
  sample.result.clock_megahertz = 1.0 / 3;
  for (const StatisticRow& row : statistic_rows(sample.report))
    if (row.statistic == "clock") CHECK(std::stod(row.value) == 1.0 / 3);
}

TEST_CASE("angles of a run in which no vector lights the surface have no value") {
  Sample sample;
  sample.result.angular_errors = {AngularError{}};
  int empty = 0;
  for (const StatisticRow& row : statistic_rows(sample.report)) {
    if (row.module != "angular_error.hardware.") continue;
    if (row.statistic == "count") CHECK(row.value == "0");
    empty += row.value.empty() ? 1 : 0;
  }
  CHECK(empty == 3);
}

TEST_CASE("the table has four columns in every line, and awkward names are quoted") {
  const Sample sample;
  std::istringstream text(to_csv(statistic_rows(sample.report)));
  std::string line;
  std::getline(text, line);
  CHECK(line == "module,statistic,value,unit");
  while (std::getline(text, line)) CHECK(std::count(line.begin(), line.end(), ',') == 3);
  CHECK(to_csv({{"a,b", "say \"x\"", "1", ""}}) == "module,statistic,value,unit\n\"a,b\",\"say \"\"x\"\"\",1,\n");
}
