// Dates and statistics worked out by hand from the formulas of timing_graph.h.

#include <catch2/catch.hpp>

#include "run_engines.h"
#include "small_pipelines.h"

using namespace bump;
using namespace bump::test;

namespace {

TimingResult dated(const TimingCase& timing_case) {
  const Outcome outcome = run_dated(timing_case);
  REQUIRE(outcome.error.empty());
  return outcome.result;
}

}  // namespace

TEST_CASE("a FIFO of depth 1 passes one token every two cycles") {
  // s0 = 0, 1; w0 = 1, 3, 5 ...; s1 = 2, 4, 6 ...; w1 = 3, 5, 7 ...
  const TimingResult result = dated(pair_of_stages(1, 10));
  REQUIRE(result.cycles == 22);
  REQUIRE(result.stages[1] == StageStatistics{"second", 10, 10, 2 + 9, 0, 0, 21});
  REQUIRE(result.fifos[0] == FifoStatistics{"between", 1, 10, 1, 10, 12});
}

TEST_CASE("a FIFO of depth 2 passes one token a cycle") {
  const TimingResult result = dated(pair_of_stages(2, 10));
  REQUIRE(result.cycles == 13);
  REQUIRE(result.stages[0] == StageStatistics{"first", 10, 10, 0, 0, 0, 10});
  REQUIRE(result.stages[1] == StageStatistics{"second", 10, 10, 2, 0, 0, 12});
  REQUIRE(result.fifos[0] == FifoStatistics{"between", 2, 10, 1, 0, 3});
}

TEST_CASE("one token a cycle takes latency + 1 tokens in flight") {
  // Capacity 3 and latency 5: starts at 0, 1, 2, then 6, 7, 8, each six cycles after the one three before.
  const TimingResult limited = dated(one_stage(5, 3, 6));
  REQUIRE(limited.cycles == 14);
  REQUIRE(limited.stages[0] == StageStatistics{"only", 6, 6, 0, 3, 0, 13});
  REQUIRE(dated(one_stage(5, 6, 100)).stages[0].blocked_room == 0);
  REQUIRE(dated(one_stage(5, 6, 100)).cycles == 105);
  REQUIRE(dated(one_stage(5, 5, 100)).stages[0].blocked_room == 19);
}

TEST_CASE("an initiation interval of three takes three cycles a token") {
  TimingCase timing_case = one_stage(1, 2, 10);
  for (TokenRecord& record : timing_case.records[0]) record.interval = 3;
  const TimingResult result = dated(timing_case);
  REQUIRE(result.cycles == 29);
  REQUIRE(result.stages[0].busy == 30);  // the last interval counts in full
}

TEST_CASE("a lead delays one result and, in order, those behind it") {
  TimingCase timing_case = one_stage(2, 8, 3);
  timing_case.records[0][0].lead = 10;
  REQUIRE(dated(timing_case).cycles == 15);  // w = 12, 13, 14
}

TEST_CASE("misses share a bus and a bounded number of slots") {
  // Asked at 1, 2, 3, 4. Granted at 1; 5 (bus); 12 (first fill 11); 16 (bus and second fill 15). Filled at 11, 15, 22, 26.
  const TimingResult result = dated(four_misses());
  REQUIRE(result.cycles == 28);
  REQUIRE(result.memories[0] == MemoryStatistics{"memory", 4, 16});
}

TEST_CASE("a batch starts when it is gathered, the last one at the end of the stream") {
  // w0 = 1, 2, 3, 4, then 6 and 7 as slots are freed at 5 and 6; s1 = 5, 6, 7, 8, then 9 and 10.
  const TimingResult result = dated(batches_of_four(4));
  REQUIRE(result.cycles == 12);
  REQUIRE(result.stages[0].blocked_output == 1);
  REQUIRE(result.stages[1] == StageStatistics{"second", 6, 6, 5, 0, 0, 11});
  REQUIRE(result.fifos[0] == FifoStatistics{"between", 4, 6, 4, 1, 12 - 9});
}

TEST_CASE("a triangle leaves with its last fragment, and one without fragments gives nothing") {
  const TimingResult result = dated(rasterizer());
  REQUIRE(result.fifos[0].items == 3);
  REQUIRE(result.fifos[1].items == 5);
  REQUIRE(result.stages[1].tokens == 6);
  // Triangles arrive at 2, 3 and (when the first has left at 4) 6; fragments at 2, 3, 4, the empty triangle at 5, fragments at 6, 7.
  REQUIRE(result.stages[1] == StageStatistics{"second", 6, 6, 2, 0, 0, 8});
  REQUIRE(result.cycles == 11);
}

TEST_CASE("without tokens nothing happens in no time") {
  const TimingResult result = dated(pair_of_stages(2, 0));
  REQUIRE(result.cycles == 0);
  REQUIRE(result.stages[0] == StageStatistics{"first", 0, 0, 0, 0, 0, -1});
  REQUIRE(result.fifos[0] == FifoStatistics{"between", 2, 0, 0, 0, 0});
}

TEST_CASE("dates are known as soon as records are there") {
  const TimingCase timing_case = pair_of_stages(2, 10);
  Timeline timeline(timing_case.graph);
  REQUIRE(timeline.latest() == -1);
  timeline.append_uniform(0, TokenRecord(), 10);
  timeline.advance();
  REQUIRE(timeline.latest() == 2);  // two slots
  timeline.append_uniform(1, TokenRecord(), 10);
  timeline.advance();
  REQUIRE(timeline.latest() == 12);
  REQUIRE(timeline.finish().cycles == 13);
}

TEST_CASE("records that contradict each other are a failed self-check") {
  for (const int excess : {-1, 1}) {
    TimingCase timing_case = pair_of_stages(2, 10);
    timing_case.records[1].resize(static_cast<std::size_t>(10 + excess));
    Timeline timeline(timing_case.graph);
    for (int i = 0; i < 2; ++i) timeline.append_uniform(i, TokenRecord(), timing_case.records[static_cast<std::size_t>(i)].size());
    REQUIRE_THROWS_AS(timeline.finish(), Error);
    try {
      Timeline again(timing_case.graph);
      for (int i = 0; i < 2; ++i) again.append_uniform(i, TokenRecord(), timing_case.records[static_cast<std::size_t>(i)].size());
      again.finish();
    } catch (const Error& error) {
      REQUIRE(error.kind() == ErrorKind::self_check);
      REQUIRE(error.text().what == "FIFO between is given 10 items, but " + std::to_string(10 + excess) + " are removed from it");
    }
  }
}

TEST_CASE("a record that does not fit its stage is a broken invariant") {
  Timeline timeline(one_stage(1, 2, 0).graph);
  TokenRecord no_interval, misses;
  no_interval.interval = 0;
  misses.misses = 1;
  REQUIRE_THROWS_AS(timeline.append_uniform(0, no_interval, 1), Error);
  REQUIRE_THROWS_AS(timeline.append_uniform(0, misses, 1), Error);
  REQUIRE_THROWS_AS(timeline.append_uniform(1, TokenRecord(), 1), Error);
  Timeline second(pair_of_stages(2, 0).graph);
  TokenRecord removes_untaken;
  removes_untaken.take = 0;
  REQUIRE_THROWS_AS(second.append_uniform(1, removes_untaken, 1), Error);
}

TEST_CASE("deeper FIFOs and more tokens in flight never cost cycles") {
  for (std::uint64_t seed = 50000; seed < 50300; ++seed) {
    const TimingCase timing_case = random_case(seed);
    const Outcome before = run_dated(timing_case);
    if (!before.error.empty()) continue;
    TimingCase larger = timing_case;
    Random random(seed);
    for (FifoSpec& fifo : larger.graph.fifos) fifo.depth += random.between(0, 3);
    for (StageSpec& stage : larger.graph.stages) stage.capacity += random.between(0, 3);
    INFO("seed " << seed);
    const TimingResult after = dated(larger);
    REQUIRE(after.cycles <= before.result.cycles);
  }
}
