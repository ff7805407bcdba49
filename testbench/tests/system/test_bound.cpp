// The closed-form bound and the self-checks of a run.

#include <catch2/catch.hpp>

#include "channels/timeline.h"
#include "system/bound.h"
#include "system/self_check.h"

using namespace bump;

namespace {

/// Two stages, the second slow or the FIFO shallow or the memory narrow, as the test wants; 1000 tokens of which every `miss_every`-th misses.
struct Machine {
  TimingGraph graph;
  std::uint32_t interval = 1;
  int miss_every = 0;

  Machine() {
    graph.stages = {{"first", 3, 64, 1, -1}, {"second", 5, 64, 1, 0}};
    graph.fifos = {{"first_to_second", 0, 1, 16}};
    graph.memories = {{"memory", 1, 20, 4, 8}};
  }

  TimingResult run() const {
    Timeline timeline(graph);
    const int tokens = 1000;
    timeline.append_uniform(0, TokenRecord{}, tokens);
    for (int i = 0; i < tokens; ++i) {
      TokenRecord record;
      record.interval = interval;
      record.misses = miss_every > 0 && i % miss_every == 0 ? 1 : 0;
      timeline.append(1, &record, 1);
    }
    return timeline.finish();
  }
};

void binds(const Machine& machine, const std::string& by) {
  const TimingResult result = machine.run();
  const Bound bound = lower_bound(machine.graph, result, {1, Cycle{machine.interval}});
  INFO(bound.by << ": " << bound.cycles << " of " << result.cycles);
  CHECK(bound.by == by);
  CHECK(bound.cycles <= static_cast<double>(result.cycles));
  CHECK(bound.cycles > 0.9 * static_cast<double>(result.cycles));
}

}  // namespace

TEST_CASE("a slow stage binds by its initiation interval") {
  Machine machine;
  machine.interval = 3;
  binds(machine, "second: initiation interval");
}

TEST_CASE("a FIFO of one slot binds at two cycles a token") {
  Machine machine;
  machine.graph.fifos[0].depth = 1;
  binds(machine, "fifos.first_to_second: depth");
}

TEST_CASE("too few tokens in flight bind") {
  Machine machine;
  machine.graph.stages[1].capacity = 2;
  binds(machine, "second: capacity in flight");
}

TEST_CASE("memory binds by bandwidth, or by the misses it holds") {
  Machine narrow;
  narrow.miss_every = 1;
  narrow.graph.memories[0].cycles_per_line = 9;
  binds(narrow, "memory: bandwidth");
  Machine few;
  few.miss_every = 1;
  few.graph.memories[0].outstanding = 2;
  binds(few, "memory: outstanding misses");
}

TEST_CASE("a run whose numbers contradict one another fails its self-check") {
  SimulationResult result;
  TimingGraph graph;
  for (int i = 0; i < 8; ++i) graph.stages.push_back({"stage", 1, 2, 1, -1});
  for (int i = 0; i < 7; ++i) graph.fifos.push_back({"fifo", i, i + 1, 2});
  const std::vector<Cycle> none(8, 0);
  result.timing.stages.resize(8);
  result.timing.fifos.resize(7);
  result.timing.memories.resize(1);
  CHECK_NOTHROW(check_conservation(result, graph, none));
  const auto fails = [&](const SimulationResult& wrong) {
    try {
      check_conservation(wrong, graph, none);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::self_check;
    }
    return false;
  };
  SimulationResult lost = result;
  lost.geometry.fragments = lost.geometry.fragments_generated = 1;
  CHECK(fails(lost));
  SimulationResult hits = result;
  hits.texture.hits = 1;
  CHECK(fails(hits));
  SimulationResult requests = result;
  requests.timing.memories[0].requests = 2;
  CHECK(fails(requests));
  SimulationResult busy = result;
  busy.timing.stages[0].busy = 3;
  CHECK(fails(busy));
  SimulationResult light_maps = result;
  light_maps.light_maps.resize(1);
  CHECK(fails(light_maps));  // without a port
  light_maps.timing.memories.resize(2);
  CHECK_FALSE(fails(light_maps));
  SimulationResult missed = light_maps;
  missed.light_maps[0].counters.misses = 1;
  CHECK(fails(missed));
  SimulationResult unread = light_maps;
  unread.timing.memories[1].requests = 1;
  CHECK(fails(unread));
  SimulationResult fast = result;
  fast.bound.cycles = 1;
  CHECK(fails(fast));
}
