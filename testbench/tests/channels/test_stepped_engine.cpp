// The clocked engine on the pipelines that are dated by hand, its waveforms, and its silence.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "run_engines.h"
#include "small_pipelines.h"

using namespace bump;
using namespace bump::test;

TEST_CASE("the clocked engine agrees with the timeline on every pipeline that is dated by hand") {
  const std::vector<TimingCase> cases = {pair_of_stages(1, 10), pair_of_stages(2, 10), one_stage(5, 3, 6),   four_misses(),
                                         batches_of_four(4),    rasterizer(),          pair_of_stages(2, 0), uneven_branches(12, 4)};
  const std::vector<Outcome> outcomes = run_stepped(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO("pipeline " << i);
    REQUIRE(outcomes[i].error.empty());
    REQUIRE(outcomes[i].result == run_dated(cases[i]).result);
  }
}

namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// What `run` and the kernel print on stdout.
template <class Run>
std::string printed(Run run) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / ("bump_stdout_" + std::to_string(getpid()));
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO);
  REQUIRE(std::freopen(path.c_str(), "w", stdout) != nullptr);
  run();
  std::fflush(stdout);
  dup2(before, STDOUT_FILENO);
  close(before);
  const std::string text = contents(path);
  std::filesystem::remove(path);
  return text;
}

}  // namespace

TEST_CASE("a traced run stops the simulation by itself, prints nothing, and leaves waveforms") {
  // The kernel's remarks are on for a program that has not switched them off.
  sc_core::sc_report_handler::set_actions("/OSCI/SystemC", sc_core::SC_INFO, sc_core::SC_DEFAULT_INFO_ACTIONS);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / ("bump_waves_" + std::to_string(getpid()));
  const TimingCase timing_case = four_misses();
  TimingResult result;
  const std::string text = printed([&] {
    SteppedEngine engine("engine", timing_case.graph, sc_core::sc_time(10, sc_core::SC_NS), [] { return false; });
    engine.append(0, timing_case.records[0].data(), timing_case.records[0].size());
    engine.trace(path.string());
    sc_core::sc_start();
    REQUIRE(engine.now() == 28);
    result = engine.result();
  });
  REQUIRE(text.empty());
  REQUIRE(result == run_dated(timing_case).result);
  REQUIRE(sc_core::sc_end_of_simulation_invoked());

  const std::filesystem::path waves = path.string() + ".vcd";
  const std::string vcd = contents(waves);
  std::filesystem::remove(waves);
  for (const char* name : {"in_flight", "busy", "state", "output_blocked", "bus_busy", "filled"}) {
    INFO(name);
    REQUIRE(vcd.find(name) != std::string::npos);
  }
  REQUIRE(vcd.find("#280000") != std::string::npos);  // ps: the edge of cycle 27
}

TEST_CASE("what the supply of records throws comes back with the result") {
  SteppedEngine engine("engine", one_stage(1, 2, 0).graph, sc_core::sc_time(10, sc_core::SC_NS),
                       []() -> bool { throw Error({"no more paper"}); });
  sc_core::sc_start();
  REQUIRE_THROWS_WITH(engine.result(), "no more paper");
}

TEST_CASE("records that do not come within a cycle end the simulation with an error") {
  sc_core::sc_event never;
  SteppedEngine engine("engine", one_stage(1, 2, 0).graph, sc_core::sc_time(10, sc_core::SC_NS), [&] {
    sc_core::wait(never);
    return true;
  });
  sc_core::sc_start();
  REQUIRE_THROWS_AS(engine.result(), Error);
}

TEST_CASE("records may be supplied after waiting in zero time") {
  const TimingCase timing_case = pair_of_stages(2, 40);
  std::size_t used = 0;
  SteppedEngine* target = nullptr;
  SteppedEngine engine("engine", timing_case.graph, sc_core::sc_time(10, sc_core::SC_NS), [&] {
    sc_core::wait(sc_core::SC_ZERO_TIME);
    if (used == 40) return false;
    for (int i = 0; i < 2; ++i) target->append_uniform(i, TokenRecord(), 4);
    used += 4;
    return true;
  });
  target = &engine;
  sc_core::sc_start();
  REQUIRE(engine.result() == run_dated(timing_case).result);
}
