#pragma once
// Pipelines small enough to date by hand.

#include "random_timing.h"

namespace bump::test {

inline StageSpec stage_of(const std::string& name, Cycle latency, std::int64_t capacity, int batch = 1) {
  StageSpec stage;
  stage.name = name;
  stage.latency = latency;
  stage.capacity = capacity;
  stage.batch = batch;
  return stage;
}

/// `tokens` ordinary tokens through two stages of latency 1.
inline TimingCase pair_of_stages(std::int64_t depth, std::size_t tokens, std::int64_t capacity = 2) {
  TimingCase result;
  result.graph.stages = {stage_of("first", 1, capacity), stage_of("second", 1, capacity)};
  result.graph.fifos = {{"between", 0, 1, depth}};
  result.records.assign(2, std::vector<TokenRecord>(tokens));
  return result;
}

inline TimingCase one_stage(Cycle latency, std::int64_t capacity, std::size_t tokens) {
  TimingCase result;
  result.graph.stages = {stage_of("only", latency, capacity)};
  result.records.assign(1, std::vector<TokenRecord>(tokens));
  return result;
}

/// Four misses in a row: latency 10, four cycles a line, two in flight.
inline TimingCase four_misses() {
  TimingCase result = one_stage(1, 16, 4);
  result.graph.stages[0].memory = 0;
  result.graph.memories = {{"memory", 1, 10, 4, 2}};
  for (TokenRecord& record : result.records[0]) record.misses = 1;
  return result;
}

/// Six tokens into a stage that gathers four.
inline TimingCase batches_of_four(std::int64_t depth) {
  TimingCase result = pair_of_stages(depth, 6);
  result.graph.stages[1].batch = 4;
  return result;
}

/// Two triangles with three and no fragments, then one with two: the rasterizer's tokens are fragments.
inline TimingCase rasterizer() {
  TimingCase result = pair_of_stages(2, 3);
  result.graph.stages.push_back(stage_of("third", 1, 2));
  result.graph.fifos.push_back({"fragments", 1, 2, 2});
  TokenRecord stays, leaves, empty;
  stays.release = 0;
  empty.give = 0;
  result.records[1] = {stays, stays, leaves, empty, stays, leaves};
  result.records.push_back(std::vector<TokenRecord>(5));
  return result;
}

/// A fork whose branches meet again; one branch gathers `batch` tokens, the other holds `depth`.
inline TimingCase uneven_branches(std::int64_t depth, int batch) {
  TimingCase result;
  result.graph.stages = {stage_of("fork", 1, 2), stage_of("gather", 1, 2, batch), stage_of("join", 1, 2)};
  result.graph.fifos = {{"to_gather", 0, 1, 16}, {"direct", 0, 2, depth}, {"gathered", 1, 2, 16}};
  result.records.assign(3, std::vector<TokenRecord>(32));
  return result;
}

}  // namespace bump::test
