// Dating again says what a run says, whatever the depths, latencies, capacities, multiplier limits and memories.

#include <catch2/catch.hpp>

#include "retime_bench.h"
#include "testbench/experiments/retime.h"

using namespace bump;
using namespace bump::test;

namespace {

std::string retimed_text(Retimer& retimer, const Configuration& configuration) {
  try {
    const RetimedRun run = retimer.retime(configuration);
    return text_of(run.timing, run.bound);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::deadlock) throw;
    return error.what();
  }
}

std::string text_of(const SweepRow& row) {
  if (row.error) return row.error->what();
  TimingResult timing;
  timing.cycles = row.cycles;
  timing.stages = row.stages;
  return bump::test::text_of(timing, row.bound);
}

}  // namespace

TEST_CASE("a trace that is dated again says what a run with those settings says") {
  std::mt19937_64 random(2026);
  std::size_t deadlocks = 0;
  for (const Scheme* scheme : all_schemes()) {
    const std::string& id = scheme->page().id;
    INFO(id);
    Settings values;
    if (random() % 2 == 0) values.values.emplace_back("numeric", "double");
    if (random() % 2 == 0) values.values.emplace_back("rasterizer.order", "tiled");
    if (random() % 2 == 0) values.values.emplace_back("texture_fetch.cache.sets", "2");
    if (id == "kugler1998") values.values.emplace_back("kugler1998.light_map_bits", "11");
    const Configuration base = values.applied_to(Configuration(all_parameters()));
    std::vector<Configuration> configurations{base};
    for (int i = 0; i < 5; ++i) configurations.push_back(random_timing_settings(random, base.parameters()).applied_to(base));

    std::vector<ChildTask> tasks{recorded_run(id, base, true)};
    for (const Configuration& configuration : configurations) tasks.push_back(recorded_run(id, configuration, false));
    const std::vector<std::string> said = outcomes_of(tasks);
    Retimer retimer(decode_trace(said[0], "test"), all_parameters(), "test");
    for (std::size_t i = 0; i < configurations.size(); ++i) {
      CHECK_NOTHROW(retimer.check(configurations[i]));
      CHECK(retimed_text(retimer, configurations[i]) == said[i + 1]);
      deadlocks += said[i + 1].rfind("deadlock", 0) == 0 ? 1U : 0U;
    }
  }
  CHECK(deadlocks > 0);
}

TEST_CASE("what is recorded does not depend on the parameters that are only timing") {
  std::mt19937_64 random(7);
  for (const std::string id : {"lee2007", "kugler1998"}) {
    INFO(id);
    const Configuration base = Settings{{{"kugler1998.light_map_bits", "11"}}}.applied_to(Configuration(all_parameters()));
    std::vector<ChildTask> tasks{recorded_run(id, base, true)};
    for (int i = 0; i < 4; ++i)
      tasks.push_back(recorded_run(id, random_timing_settings(random, base.parameters(), false).applied_to(base), true));
    const std::vector<std::string> traces = outcomes_of(tasks);
    const auto streams = [](const std::string& bytes) {
      TimingTrace trace = decode_trace(bytes, "test");
      trace.cycles = 0;
      trace.configuration.clear();
      return encode_trace(trace);
    };
    for (const std::string& other : traces) CHECK((streams(other) == streams(traces[0])));
  }
}

TEST_CASE("the clocked engine records what the dated one records") {
  const auto recorded_by = [](Engine engine) {
    return ChildTask{"engine", [engine](const ReportShare&) {
                       const Configuration configuration(all_parameters());
                       const Scene scene = retime_scene();
                       TraceRecorder recorder;
                       SimulationOptions options;
                       options.engine = engine;
                       options.record = [&recorder](const TimingRecords& records) { recorder.add(records); };
                       const Scheme& scheme = find_scheme("lee2007");
                       const std::int64_t cycles = simulate(scene, scheme, configuration, options).timing.cycles;
                       return encode_trace(recorder.finish(scene, scheme, configuration, cycles));
                     }};
  };
  const std::vector<std::string> traces = outcomes_of({recorded_by(Engine::dated), recorded_by(Engine::stepped)});
  CHECK((traces[0] == traces[1]));
}

TEST_CASE("a parameter that is more than timing is refused, unless it keeps its value") {
  Retimer retimer(record("kugler1998", {{{"kugler1998.light_map_bits", "11"}}}), all_parameters(), "test");
  CHECK_NOTHROW(retimer.check(retimer.recorded()));
  for (const auto& [key, parameter] : retimer.recorded().parameters().all()) {
    if (parameter.timing_only) continue;
    INFO(key);
    Configuration other = retimer.recorded();
    const ParameterValue value = other.entries().at(key).value;
    other.set(key, value, {"test", 0, 0});
    CHECK_NOTHROW(retimer.check(other));
    if (std::holds_alternative<bool>(value))
      other.set(key, !std::get<bool>(value), {"test", 0, 0});
    else if (const auto* word = std::get_if<std::string>(&value))
      other.set(key, *word == parameter.choices.front() ? parameter.choices.back() : parameter.choices.front(), {"test", 0, 0});
    else if (const auto* number = std::get_if<double>(&value))
      other.set(key, *number == parameter.low ? parameter.high : parameter.low, {"test", 0, 0});
    else
      other.set(
          key,
          static_cast<std::int64_t>(static_cast<double>(std::get<std::int64_t>(value)) == parameter.low ? parameter.high : parameter.low),
          {"test", 0, 0});
    CHECK_THROWS_WITH(retimer.check(other), Catch::Contains(key) && Catch::Contains("record again"));
  }
}

TEST_CASE("a trace of datapaths that the program no longer builds is refused") {
  TimingTrace trace = record("lee2007");
  SECTION("the netlists differ") {
    trace.netlists[0] = trace.netlists[0] == '0' ? '1' : '0';
  }
  SECTION("the scheme is gone") {
    trace.scheme = "lee2008";
  }
  SECTION("a parameter is gone") {
    trace.configuration.front().first = "ancient.key";
  }
  SECTION("a parameter is missing") {
    trace.configuration.pop_back();
  }
  CHECK_THROWS_WITH(Retimer(trace, all_parameters(), "old.trace"), Catch::Contains("old.trace") && Catch::Contains("--record"));
}

TEST_CASE("a run that does not come out as it was recorded fails its self-check") {
  TimingTrace trace = record("phong1975");
  ++trace.cycles;
  Retimer retimer(trace, all_parameters(), "test");
  try {
    retimer.retime(retimer.recorded());
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::self_check);
  }
}

TEST_CASE("a sweep has the rows of its points, with and without vectors, for any number of threads") {
  for (const std::string id : {"peercy1997", "kugler1998"}) {
    INFO(id);
    Settings values;
    if (id == "kugler1998") values.values.emplace_back("kugler1998.light_map_bits", "11");
    Retimer retimer(record(id, values), all_parameters(), "test");
    const SweepGrid grid({"fifos.depth=1,3,9,20000", "memory.latency=1,40,1048576", "environment.multipliers=0,1,2",
                          "texture_fetch.batch=1,2", "datapath.latency.adder=1,3"},
                         retimer.recorded().parameters());
    SweepOptions options;
    options.jobs = 1;
    const std::vector<SweepRow> rows = sweep(retimer, retimer.recorded(), grid, options);
    REQUIRE(rows.size() == grid.points());
    options.jobs = 3;
    const std::vector<SweepRow> with_threads = sweep(retimer, retimer.recorded(), grid, options);
    options.vectors = false;
    const std::vector<SweepRow> one_by_one = sweep(retimer, retimer.recorded(), grid, options);
    std::size_t deadlocks = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      INFO("point " << i);
      CHECK(text_of(rows[i]) == text_of(one_by_one[i]));
      CHECK(text_of(rows[i]) == text_of(with_threads[i]));
      deadlocks += rows[i].error ? 1U : 0U;
    }
    CHECK(deadlocks == grid.points() / 4 / 2);  // depth 1 with batch 2
    Configuration point = retimer.recorded();
    grid.apply(17, point);
    if (!rows[17].error) CHECK(rows[17].cycles == retimer.retime(point).timing.cycles);
  }
}

TEST_CASE("a sweep that is interrupted says so") {
  Retimer retimer(record("phong1975"), all_parameters(), "test");
  const SweepGrid grid({"fifos.depth=1,2,3,4,5,6,7,8,9"}, retimer.recorded().parameters());
  std::atomic<bool> cancelled{true};
  SweepOptions options;
  options.cancelled = &cancelled;
  try {
    sweep(retimer, retimer.recorded(), grid, options);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::cancelled);
  }
}

TEST_CASE("a grid is the product of its axes, the last fastest") {
  const Parameters parameters = all_parameters();
  const SweepGrid grid({"fifos.depth=1,2,4", "memory.latency=10,20"}, parameters);
  CHECK(grid.points() == 6);
  CHECK(grid.values(0) == std::vector<std::string>{"1", "10"});
  CHECK(grid.values(1) == std::vector<std::string>{"1", "20"});
  CHECK(grid.values(5) == std::vector<std::string>{"4", "20"});
  CHECK(SweepGrid({}, parameters).points() == 1);
  CHECK_THROWS_WITH(SweepGrid({"fifos.dept=1"}, parameters), Catch::Contains("fifos.depth"));
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth=1,0"}, parameters), Catch::Contains("out of range"));
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth=1,,2"}, parameters), Catch::Contains("whole number"));
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth=1,2,1"}, parameters), Catch::Contains("twice"));
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth=1", "fifos.depth=2"}, parameters), Catch::Contains("twice"));
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth"}, parameters), Catch::Contains("no sweep"));
  std::string many = "1";
  for (int i = 2; i <= 1001; ++i) many += "," + std::to_string(i);
  CHECK_THROWS_WITH(SweepGrid({"fifos.depth=" + many, "memory.latency=" + many}, parameters), Catch::Contains("more than 200000 points"));
}
