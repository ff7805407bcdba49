#include <catch2/catch.hpp>

#include "channels/timing_graph.h"
#include "datapath/error.h"

using namespace bump;
using Catch::Matchers::Contains;

namespace {

TimingGraph diamond() {
  TimingGraph graph;
  for (const char* name : {"source", "left", "right", "join"}) {
    StageSpec stage;
    stage.name = name;
    graph.stages.push_back(stage);
  }
  graph.fifos = {{"to_left", 0, 1, 2}, {"to_right", 0, 2, 2}, {"from_left", 1, 3, 2}, {"from_right", 2, 3, 2}};
  graph.memories.push_back({"memory", 1, 40, 4, 4});
  return graph;
}

/// The message with which a graph is rejected after `change`; "" if it is accepted.
template <class Change>
std::string rejection(Change change) {
  TimingGraph graph = diamond();
  change(graph);
  try {
    graph.validate();
  } catch (const Error& error) {
    REQUIRE(error.kind() == ErrorKind::input);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the FIFOs of a stage come in the order of the graph") {
  const TimingGraph graph = diamond();
  REQUIRE(graph.inputs_of(0).empty());
  REQUIRE(graph.outputs_of(0) == std::vector<int>{0, 1});
  REQUIRE(graph.inputs_of(3) == std::vector<int>{2, 3});
  REQUIRE(graph.outputs_of(3).empty());
}

TEST_CASE("a graph within its ranges is accepted") {
  REQUIRE(rejection([](TimingGraph&) {}).empty());
  REQUIRE(rejection([](TimingGraph& g) { g = TimingGraph(); }).empty());
}

TEST_CASE("every number out of range is rejected by name") {
  CHECK_THAT(rejection([](TimingGraph& g) { g.stages[1].latency = 0; }), Contains("latency of stage 'left' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.stages[2].capacity = 0; }), Contains("capacity of stage 'right' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.stages[3].batch = 0; }), Contains("batch of stage 'join' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.stages[3].memory = 1; }), Contains("memory port of stage 'join' is 1"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos[0].depth = 0; }), Contains("depth of FIFO 'to_left' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos[0].to = 4; }), Contains("destination stage of FIFO 'to_left' is 4"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos[0].from = -1; }), Contains("source stage of FIFO 'to_left' is -1"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.memories[0].tag_latency = 0; }), Contains("tag latency of memory port 'memory' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.memories[0].latency = 0; }), Contains("latency of memory port 'memory' is 0"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.memories[0].cycles_per_line = 0; }), Contains("cycles per line of memory port"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.memories[0].outstanding = 0; }), Contains("outstanding misses of memory port"));
}

TEST_CASE("an edge that points backwards, too many ports and a shared memory port are rejected") {
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos[2] = {"back", 3, 1, 2}; }), Contains("FIFO 'back' runs backwards"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos[2] = {"self", 1, 1, 2}; }), Contains("FIFO 'self' runs backwards"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.fifos.insert(g.fifos.end(), 8, g.fifos[0]); }), Contains("more than 8 inputs or outputs"));
  CHECK_THAT(rejection([](TimingGraph& g) { g.stages[1].memory = g.stages[2].memory = 0; }),
             Contains("stages 'left' and 'right' share memory port 'memory'"));
}

TEST_CASE("results are equal only if every field is") {
  TimingResult result;
  result.cycles = 3;
  result.stages.resize(1);
  result.fifos.resize(1);
  result.memories.resize(1);
  REQUIRE(result == result);
  const auto differs = [&](auto change) {
    TimingResult other = result;
    change(other);
    return !(other == result);
  };
  CHECK(differs([](TimingResult& r) { r.cycles = 4; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].name = "x"; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].tokens = 1; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].busy = 1; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].starved = 1; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].blocked_room = 1; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].blocked_output = 1; }));
  CHECK(differs([](TimingResult& r) { r.stages[0].last_delivery = 1; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].name = "x"; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].depth = 1; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].items = 1; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].max_occupancy = 1; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].full_cycles = 1; }));
  CHECK(differs([](TimingResult& r) { r.fifos[0].empty_cycles = 1; }));
  CHECK(differs([](TimingResult& r) { r.memories[0].name = "x"; }));
  CHECK(differs([](TimingResult& r) { r.memories[0].requests = 1; }));
  CHECK(differs([](TimingResult& r) { r.memories[0].busy = 1; }));
}
