// The vector kernel against the timeline, on random streams and random machines.

#include <catch2/catch.hpp>
#include <random>

#include "retime_bench.h"
#include "retiming/lane_dates.h"

using namespace bump;
using namespace bump::test;

namespace {

std::uint32_t between(std::mt19937_64& random, std::uint32_t low, std::uint32_t high) {
  return low + static_cast<std::uint32_t>(random() % (high - low + 1));
}

TimingTrace random_trace(std::mt19937_64& random, bool maps) {
  std::array<TokenStreamBuilder, traced::count> streams;
  const std::uint32_t triangles = between(random, 0, 40);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    TokenRecord record;
    record.interval = between(random, 1, 9);
    record.lead = between(random, 0, record.interval - 1);
    streams[traced::vertex].append(record);
    streams[traced::setup].append(TokenRecord{between(random, 1, 6)});
    const std::uint32_t fragments = random() % 3 == 0 ? 0 : between(random, 1, 30);
    record = {};
    if (fragments == 0) {
      record.interval = between(random, 1, 20);
      record.lead = record.interval - 1;
      record.give = 0;
      streams[traced::raster].append(record);
    }
    for (std::uint32_t f = 0; f < fragments; ++f) {
      record.lead = random() % 5 == 0 ? between(random, 0, 7) : 0;
      record.interval = 1 + record.lead;
      record.release = f + 1 == fragments ? 1 : 0;
      streams[traced::raster].append(record);
      TokenRecord fetch;
      fetch.interval = random() % 6 == 0 ? 2 : 1;
      fetch.misses = static_cast<std::uint16_t>(random() % 8 == 0 ? between(random, 1, 3) : 0);
      streams[traced::texture].append(fetch);
      fetch.misses = static_cast<std::uint16_t>(random() % 10 == 0 ? between(random, 1, 2) : 0);
      if (maps) streams[traced::light_map].append(fetch);
    }
  }
  TimingTrace trace;
  for (std::size_t i = 0; i < traced::count; ++i) trace.streams[i] = streams[i].stream();
  check_trace(trace);
  return trace;
}

PipelineTiming random_machine(std::mt19937_64& random, bool maps) {
  DatapathSchedules schedules;
  for (Schedule* schedule :
       {&schedules.conversion, &schedules.environment, &schedules.illumination, &schedules.colour, &schedules.light_map_address}) {
    schedule->latency = static_cast<int>(between(random, 0, 9));
    schedule->initiation_interval = static_cast<int>(random() % 3 == 0 ? between(random, 1, 4) : 1);
  }
  if (maps) schedules.light_map_address.start = {0};
  if (random() % 2 == 0) schedules.conversion.start = {0};
  const Configuration base(all_parameters());
  const int passes = static_cast<int>(between(random, 1, 2));
  return make_pipeline_timing(schedules, passes, random_timing_settings(random, base.parameters(), false).applied_to(base));
}

void check_same(const Retimed& vector, const Retimed& scalar) {
  CHECK(vector.timing.cycles == scalar.timing.cycles);
  CHECK(vector.timing.stages == scalar.timing.stages);
  CHECK(vector.timing.memories == scalar.timing.memories);
  CHECK(vector.last_interval == scalar.last_interval);
  REQUIRE(vector.timing.fifos.size() == scalar.timing.fifos.size());
  for (std::size_t i = 0; i < vector.timing.fifos.size(); ++i) {
    CHECK(vector.timing.fifos[i].name == scalar.timing.fifos[i].name);
    CHECK(vector.timing.fifos[i].items == scalar.timing.fifos[i].items);
  }
}

}  // namespace

TEST_CASE("eight machines at once have the dates that each has alone") {
  std::mt19937_64 random(11);
  for (int round = 0; round < 60; ++round) {
    INFO("round " << round);
    const bool maps = random() % 2 == 0;
    const TimingTrace trace = random_trace(random, maps);
    const TokenProgram program = make_token_program(trace);
    std::vector<PipelineTiming> machines;
    for (std::uint32_t i = between(random, 1, LaneDates::width); i > 0; --i) machines.push_back(random_machine(random, maps));
    std::vector<const PipelineTiming*> pointers;
    for (const PipelineTiming& machine : machines) {
      REQUIRE(LaneDates::serves(machine));
      pointers.push_back(&machine);
    }
    LaneDates lanes(program, pointers);
    REQUIRE(lanes.run(nullptr));
    for (std::size_t i = 0; i < machines.size(); ++i) check_same(lanes.result(i), replay(trace, machines[i]));
  }
}

TEST_CASE("runs longer than a block, and dates that outgrow their width") {
  std::array<TokenStreamBuilder, traced::count> streams;
  streams[traced::vertex].append(TokenRecord{});
  streams[traced::setup].append(TokenRecord{});
  TokenRecord record;
  record.release = 0;
  streams[traced::raster].append(record, 50000);
  record.release = 1;
  streams[traced::raster].append(record);
  streams[traced::texture].append(TokenRecord{}, 50001);
  TimingTrace trace;
  for (std::size_t i = 0; i < traced::count; ++i) trace.streams[i] = streams[i].stream();
  check_trace(trace);
  const TokenProgram program = make_token_program(trace);
  DatapathSchedules schedules;
  const auto machine = [&](const Settings& settings) {
    return make_pipeline_timing(schedules, 1, settings.applied_to(Configuration(all_parameters())));
  };
  const PipelineTiming quick = machine({});
  LaneDates lanes(program, {&quick});
  REQUIRE(lanes.run(nullptr));
  check_same(lanes.result(0), replay(trace, quick));

  schedules.environment.initiation_interval = 1 << 20;
  const PipelineTiming slow = machine({});
  CHECK_FALSE(LaneDates(program, {&quick, &slow}).run(nullptr));
  CHECK_FALSE(LaneDates::serves(machine({{{"texture_fetch.batch", "2"}}})));
  CHECK_FALSE(LaneDates::serves(machine({{{"fifos.depth", "100000"}}})));
}
