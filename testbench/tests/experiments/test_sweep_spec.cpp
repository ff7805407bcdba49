// What a specification of a sweep means, and what is wrong with one.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "sweep_files.h"
#include "testbench/experiments/sweep_random.h"
#include "testbench/experiments/sweep_sections.h"

using namespace bump;

namespace {

const std::string heading = "scenes = [\"ball.toml\"]\nschemes = [\"lee2007\"]\n";

/// "[1, 2, 3]".
std::string list_of(std::size_t count) {
  std::string text;
  for (std::size_t i = 1; i <= count; ++i) text += (i == 1 ? "[" : ", ") + std::to_string(i);
  return text + "]";
}

std::size_t index_of(const SweepSpec& spec, const std::string& key) {
  const auto found = std::find(spec.keys.begin(), spec.keys.end(), key);
  REQUIRE(found != spec.keys.end());
  return static_cast<std::size_t>(found - spec.keys.begin());
}

std::vector<ParameterValue> column(const SweepSpec& spec, const std::string& key) {
  std::vector<ParameterValue> values;
  for (const SpecPoint& point : spec.points) values.push_back(point.values[index_of(spec, key)]);
  return values;
}

}  // namespace

TEST_CASE("a grid has the product of its lists, the last key fastest, for every scene and scheme") {
  const SweepFiles files;
  for (const auto& [a, b, c] : {std::array<std::size_t, 3>{1, 1, 1}, std::array<std::size_t, 3>{2, 3, 4},
                                std::array<std::size_t, 3>{7, 1, 2}, std::array<std::size_t, 3>{1, 5, 9}}) {
    const SweepSpec spec = files.spec("scenes = [\"ball.toml\", \"wall.toml\"]\nschemes = \"all\"\n[grid]\nfifos.depth = " + list_of(a) +
                                      "\n[grid.memory]\nlatency = " + list_of(b) + "\noutstanding = " + list_of(c) + "\n");
    const std::size_t product = a * b * c, schemes = all_schemes().size();
    CHECK(spec.keys == std::vector<std::string>{"fifos.depth", "memory.latency", "memory.outstanding"});
    REQUIRE(spec.points.size() == 2 * schemes * product);
    for (std::size_t i = 0; i < spec.points.size(); ++i) {
      const SpecPoint& point = spec.points[i];
      CHECK(point.scene == i / (schemes * product));
      CHECK(point.scheme == i / product % schemes);
      const auto value = [](std::size_t number) { return ParameterValue(static_cast<std::int64_t>(number + 1)); };
      CHECK(point.values == std::vector<ParameterValue>{value(i / (b * c) % a), value(i / c % b), value(i % c)});
    }
  }
}

TEST_CASE("one factor at a time is the base and every value alone") {
  const SweepFiles files;
  const SweepSpec spec =
      files.spec(heading + "[base]\nfifos.depth = 7\n[one_at_a_time]\nfifos.depth = [1, 2]\nmemory.latency = [1, 2, 3]\n" +
                 "numeric = \"double\"\nframe.width = [8, 9]\n");
  REQUIRE(spec.points.size() == 1 + 2 + 3 + 1 + 2);
  const std::vector<ParameterValue> base = spec.points.front().values;
  CHECK(base[index_of(spec, "fifos.depth")] == ParameterValue(std::int64_t{7}));
  CHECK(spec.points.front().width == 0);
  for (std::size_t i = 1; i < spec.points.size(); ++i) {
    int changed = spec.points[i].width == 0 ? 0 : 1;
    for (std::size_t k = 0; k < base.size(); ++k) changed += spec.points[i].values[k] == base[k] ? 0 : 1;
    CHECK(changed == 1);
  }
}

TEST_CASE("points of a list may name their own scene and scheme, and then come once") {
  const SweepFiles files;
  const SweepSpec spec = files.spec(
      "scenes = [\"ball.toml\", \"wall.toml\"]\nschemes = [\"lee2007\", \"phong1975\"]\n[[list]]\nfifos.depth = 3\n[[list]]\nscheme = "
      "\"kim2001\"\n[[list]]\nscene = \"wall.toml\"\nscheme = \"kim2001\"\nfifos.depth = 5\nframe.height = 11\n");
  REQUIRE(spec.points.size() == 4 + 2 + 1);
  std::vector<std::string> points;
  for (const SpecPoint& point : spec.points)
    points.push_back(spec.scenes[point.scene].name + " " + spec.schemes[point.scheme]->page().id + " " + to_string(point.values.front()) +
                     " " + std::to_string(point.height));
  CHECK(points == std::vector<std::string>{"ball.toml lee2007 3 0", "ball.toml kim2001 4 0", "wall.toml kim2001 5 11",
                                           "ball.toml phong1975 3 0", "wall.toml lee2007 3 0", "wall.toml kim2001 4 0",
                                           "wall.toml phong1975 3 0"});
}

TEST_CASE("a specification without sections is one point for each scene and scheme; sections add up in their order") {
  const SweepFiles files;
  CHECK(files.spec(heading).points.size() == 1);
  const SweepSpec spec =
      files.spec(heading + "[[list]]\nfifos.depth = 9\n[[grid]]\nfifos.depth = [1, 2]\n[[grid]]\nmemory.latency = [5, 6, 7]\n");
  REQUIRE(spec.points.size() == 6);
  CHECK(column(spec, "fifos.depth").front() == ParameterValue(std::int64_t{9}));
  CHECK(column(spec, "memory.latency").back() == ParameterValue(std::int64_t{7}));
}

TEST_CASE("configuration files and the base set what points leave open, the base last") {
  const SweepFiles files;
  files.write("memory.toml", "[memory]\nlatency = 77\noutstanding = 3\n");
  const SweepSpec spec =
      files.spec(heading + "config = \"memory.toml\"\nquality = false\n[base.memory]\noutstanding = 5\n[grid]\nfifos.depth = 2\n");
  CHECK(spec.base.integer("memory.latency") == 77);
  CHECK(spec.base.integer("memory.outstanding") == 5);
  CHECK_FALSE(spec.quality);
}

TEST_CASE("random values lie in their ranges, and do not depend on the other keys or on the count") {
  const SweepFiles files;
  const std::string drawn =
      "seed = 3\nmemory.latency = { low = 10, high = 1000, scale = \"log\" }\nfifos.depth = { low = 1, high = 4 }\n" +
      std::string("clock.megahertz = { low = 1.5, high = 2.5 }\ntexture_fetch.filter = [\"nearest\", \"trilinear\"]\n");
  const SweepSpec spec = files.spec(heading + "[random]\ncount = 4000\n" + drawn);
  REQUIRE(spec.points.size() == 4000);
  int below_geometric_mean = 0;
  std::map<std::int64_t, int> depths;
  std::map<std::string, int> filters;
  for (std::size_t i = 0; i < 4000; ++i) {
    const auto& values = spec.points[i].values;
    const auto drawn_latency = std::get<std::int64_t>(values[index_of(spec, "memory.latency")]);
    CHECK((drawn_latency >= 10 && drawn_latency <= 1000));
    below_geometric_mean += drawn_latency < 100 ? 1 : 0;
    ++depths[std::get<std::int64_t>(values[index_of(spec, "fifos.depth")])];
    const double clock = std::get<double>(values[index_of(spec, "clock.megahertz")]);
    CHECK((clock >= 1.5 && clock <= 2.5));
    ++filters[std::get<std::string>(values[index_of(spec, "texture_fetch.filter")])];
  }
  // Five standard deviations around what is expected.
  CHECK(std::abs(below_geometric_mean - 2000) < 160);
  REQUIRE(depths.size() == 4);
  for (const auto& [depth, count] : depths) CHECK(std::abs(count - 1000) < 140);
  REQUIRE(filters.size() == 2);

  const SweepSpec fewer = files.spec(heading + "[random]\ncount = 10\n" + drawn + "memory.outstanding = [1, 2]\n");
  for (const std::string key : {"memory.latency", "fifos.depth", "clock.megahertz", "texture_fetch.filter"}) {
    const auto all = column(spec, key), first = column(fewer, key);
    CHECK(std::equal(first.begin(), first.end(), all.begin()));
  }
  const SweepSpec other =
      files.spec(heading + "[random]\ncount = 4000\nseed = 4\nmemory.latency = { low = 10, high = 1000, scale = \"log\" }\n");
  CHECK(column(other, "memory.latency") != column(spec, "memory.latency"));
}

TEST_CASE("both ends of a range can be drawn, and a range of one value is that value") {
  const RandomDraws draws(1, "key");
  for (const bool logarithmic : {false, true}) {
    std::set<std::int64_t> seen;
    for (std::size_t i = 0; i < 1000; ++i) seen.insert(std::get<std::int64_t>(draws.in_range(i, {3, 6, logarithmic, true})));
    CHECK(seen == std::set<std::int64_t>{3, 4, 5, 6});
    CHECK(draws.in_range(7, {5, 5, logarithmic, true}) == ParameterValue(std::int64_t{5}));
    CHECK(draws.in_range(7, {0.25, 0.25, logarithmic, false}) == ParameterValue(0.25));
  }
}

TEST_CASE("what is wrong in a specification is said with its place and what is near") {
  const SweepFiles files;
  struct Wrong {
    std::string text, says;
    int line, column;
  };
  const Wrong cases[] = {
      {"scenes = [\"ball.toml\"]\nshcemes = [\"lee2007\"]\n", "schemes", 2, 1},
      {"scenes = [\"ball.toml\", \"bal.toml\"]\nschemes = \"all\"\n", "bal.toml", 1, 24},
      {"scenes = [\"ball.toml\"]\nschemes = [\"lee2008\"]\n", "lee2007", 2, 12},
      {"scenes = [\"ball.toml\"]\nschemes = [\"lee2007\", \"lee2007\"]\n", "twice", 2, 23},
      {"scenes = [\"ball.toml\"]\nschemes = []\n", "empty", 2, 11},
      {"schemes = [\"lee2007\"]\n[grid]\nfifos.depth = 1\n", "no scenes", 2, 1},
      {"scenes = [\"ball.toml\"]\n[grid]\nfifos.depth = 1\n", "no schemes", 2, 1},
      {heading + "[grid]\nfifos.depht = [1, 2]\n", "fifos.depth", 4, 7},
      {heading + "[grid]\nfifos.depth = [1, 0]\n", "out of range", 4, 19},
      {heading + "[grid]\nfifos.depth = [1, 1]\n", "twice", 4, 19},
      {heading + "[grid]\nfifos.depth = []\n", "empty", 4, 15},
      {heading + "[grid]\nfifos.depth = \"deep\"\n", "whole number", 4, 15},
      {heading + "[grid]\nfifos = [1, 2]\n", "module", 4, 1},
      {heading + "[grid]\nframe.width = [64, 20000]\n", "16384", 4, 20},
      {heading + "[grid]\nframe.widht = [64]\n", "frame.width", 4, 7},
      {heading + "[grid]\nfifos.depth = { low = 1, high = 4 }\n", "fifos.depth", 4, 17},
      {heading + "[gird]\nfifos.depth = 1\n", "grid", 3, 2},
      {heading + "[base]\nscheme = \"kim2001\"\n", "schemes = ", 4, 1},
      {heading + "[base]\nmemory.latency = [1, 2]\n", "one value", 4, 18},
      {heading + "[[list]]\nfifos.depth = [1, 2]\n", "one value", 4, 15},
      {heading + "[random]\nfifos.depth = [1, 2]\n", "count", 3, 2},
      {heading + "[random]\ncount = 0\n", "whole number from 1", 4, 9},
      {heading + "[random]\ncount = 2\nfifos.depth = { low = 4, high = 1 }\n", "swap", 5, 15},
      {heading + "[random]\ncount = 2\nfifos.depth = { low = 4 }\n", "high", 5, 15},
      {heading + "[random]\ncount = 2\nfifos.depth = { low = 1, high = 4, scal = \"log\" }\n", "scale", 5, 36},
      {heading + "[random]\ncount = 2\nfifos.depth = { low = 1, high = 4, scale = \"cubic\" }\n", "linear, log", 5, 44},
      {heading + "[random]\ncount = 2\nfifos.interpolators_to_texture_fetch = { low = 0, high = 4, scale = \"log\" }\n", "above 0", 5, 40},
      {heading + "[random]\ncount = 2\nnumeric = { low = 0, high = 4 }\n", "no numbers", 5, 11},
      {heading + "[random]\ncount = 2\nfifo.deep = { low = 1, high = 4 }\n", "unknown parameter", 5, 6},
      {heading + "quality = 3\n", "quality", 3, 11},
      {heading + "config = \"none.toml\"\n", "none.toml", 3, 10},
      {heading + "grid = 3\n", "[grid]", 3, 8},
      {heading + "[grid]\nfifos.depth = [1, 2\n", "TOML", 4, 21},
  };
  for (const Wrong& wrong : cases) {
    INFO(wrong.text);
    try {
      files.spec(wrong.text);
      FAIL("nothing is said to be wrong");
    } catch (const Error& error) {
      INFO(error.what());
      CHECK(error.kind() == ErrorKind::input);
      CHECK(std::string(error.what()).find(wrong.says) != std::string::npos);
      CHECK(error.text().where.file == files.path("sweep.toml"));
      CHECK(error.text().where.line == wrong.line);
      CHECK(error.text().where.column == wrong.column);
    }
  }
}

TEST_CASE("a sweep that is too large is refused before it is built") {
  const SweepFiles files;
  const std::string many = list_of(4000);
  CHECK_THROWS_WITH(files.spec(heading + "[grid]\nmemory.latency = " + many + "\ntexture_fetch.capacity = " + many + "\n"),
                    Catch::Contains("200000"));
  CHECK_THROWS_WITH(files.spec("scenes = [\"ball.toml\"]\nschemes = \"all\"\n[random]\ncount = 100000\nfifos.depth = [1, 2]\n"),
                    Catch::Contains("200000"));
}
