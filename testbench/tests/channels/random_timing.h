#pragma once
// Random pipelines with token records that fit together: every item that a stage gives is removed by its consumer. Chains, forks, joins,
// paths that meet again, stages whose tokens outnumber their items, tokens that give nothing, routed tokens, batches, memory ports; sizes
// from the smallest allowed.

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "channels/timing_graph.h"

namespace bump::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int percent) { return between(1, 100) <= percent; }
  std::int64_t one_of(std::initializer_list<std::int64_t> values) {
    return *(values.begin() + between(0, static_cast<std::int64_t>(values.size()) - 1));
  }

 private:
  std::mt19937_64 engine_;
};

struct TimingCase {
  TimingGraph graph;
  std::vector<std::vector<TokenRecord>> records;  ///< by stage
};

inline TimingGraph random_graph(Random& random) {
  TimingGraph graph;
  const int stages = static_cast<int>(random.between(1, 7));
  const bool chain = random.chance(40);
  for (int i = 0; i < stages; ++i) {
    StageSpec stage;
    stage.name = "stage" + std::to_string(i);
    stage.latency = random.between(1, 8);
    stage.capacity = random.one_of({1, 2, 3, 5, 9, 20});
    if (random.chance(15)) stage.batch = static_cast<int>(random.one_of({2, 3, 4, 8}));
    if (random.chance(30)) {
      stage.memory = static_cast<int>(graph.memories.size());
      graph.memories.push_back({"memory" + std::to_string(i), random.between(1, 4), random.between(1, 40), random.between(1, 6),
                                static_cast<int>(random.between(1, 5))});
    }
    graph.stages.push_back(stage);
    if (i == 0) continue;
    const std::int64_t inputs = chain ? 1 : random.one_of({0, 1, 1, 1, 2, 2, 3});
    for (std::int64_t j = 0; j < inputs; ++j) {
      const int from = chain ? i - 1 : static_cast<int>(random.between(std::max(0, i - 3), i - 1));
      if (graph.outputs_of(from).size() == 8) continue;  // the most that a stage may have
      graph.fifos.push_back({"fifo" + std::to_string(graph.fifos.size()), from, i, random.one_of({1, 1, 2, 3, 4, 8, 16})});
    }
  }
  return graph;
}

/// How irregular the tokens of a case are.
struct Habits {
  int ghosts, routed, repeated, slow, late, missing;  ///< per cent of the tokens
};

inline TokenRecord random_record(Random& random, const Habits& habits, bool has_memory) {
  TokenRecord record;
  if (random.chance(habits.slow)) record.interval = static_cast<std::uint32_t>(random.between(2, 9));
  if (random.chance(habits.late)) record.lead = static_cast<std::uint32_t>(random.between(1, 12));
  if (has_memory && random.chance(habits.missing)) record.misses = static_cast<std::uint16_t>(random.between(1, 4));
  if (random.chance(habits.ghosts)) record.give = 0;
  if (random.chance(habits.routed)) record.give = static_cast<std::uint8_t>(random.between(0, 255));
  return record;
}

/// Records for a graph; stages without input have up to `tokens` tokens. `habits_of` gives those of a stage.
template <class HabitsOf>
TimingCase random_records(TimingGraph graph, std::int64_t tokens, Random& random, const HabitsOf& habits_of) {
  TimingCase result;
  result.graph = std::move(graph);

  std::vector<std::int64_t> items(result.graph.fifos.size(), 0);  // not yet removed
  for (std::size_t i = 0; i < result.graph.stages.size(); ++i) {
    const std::vector<int> inputs = result.graph.inputs_of(static_cast<int>(i));
    const std::vector<int> outputs = result.graph.outputs_of(static_cast<int>(i));
    std::int64_t free_tokens = inputs.empty() ? random.between(0, tokens) : 0;
    const Habits habits = habits_of(i);
    std::vector<TokenRecord> records;
    for (;;) {
      TokenRecord record = random_record(random, habits, result.graph.stages[i].memory >= 0);
      record.take = 0;
      for (std::size_t j = 0; j < inputs.size(); ++j)
        if (items[static_cast<std::size_t>(inputs[j])] > 0) record.take = static_cast<std::uint8_t>(record.take | (1U << j));
      if (record.take == 0 && free_tokens-- <= 0) break;
      if (random.chance(habits.routed)) record.take = static_cast<std::uint8_t>(record.take & random.between(0, 255));
      record.release = record.take;
      if (random.chance(habits.repeated)) record.release = static_cast<std::uint8_t>(record.release & random.between(0, 255));
      for (std::size_t j = 0; j < inputs.size(); ++j)
        if ((record.release >> j) & 1U) --items[static_cast<std::size_t>(inputs[j])];
      for (std::size_t j = 0; j < outputs.size(); ++j)
        if ((record.give >> j) & 1U) ++items[static_cast<std::size_t>(outputs[j])];
      records.push_back(record);
    }
    result.records.push_back(std::move(records));
  }
  return result;
}

inline TimingCase random_case(std::uint64_t seed) {
  Random random(seed);
  TimingGraph graph = random_graph(random);
  const auto some = [&](int percent) { return random.chance(50) ? 0 : percent; };
  const Habits habits{some(20), some(10), some(40), some(20), some(15), some(50)};
  return random_records(std::move(graph), 90, random, [&](std::size_t) { return habits; });
}

/// A long chain, as pipelines are: one stage may take an item several times and give nothing, those behind it hardly ever do.
inline TimingCase random_chain(std::uint64_t seed) {
  Random random(seed);
  TimingGraph graph;
  const int stages = static_cast<int>(random.between(2, 12));
  const bool shallow = random.chance(20);
  for (int i = 0; i < stages; ++i) {
    StageSpec stage;
    stage.name = "stage" + std::to_string(i);
    stage.latency = random.between(1, 30);
    stage.capacity = random.chance(70) ? stage.latency + 1 : random.one_of({1, 2, 7, 64});
    if (random.chance(20)) {
      stage.memory = static_cast<int>(graph.memories.size());
      graph.memories.push_back({"memory" + std::to_string(i), random.between(1, 4), random.between(1, 60), random.between(1, 6),
                                static_cast<int>(random.between(1, 9))});
    }
    graph.stages.push_back(stage);
    if (i > 0) graph.fifos.push_back({"fifo" + std::to_string(i), i - 1, i, random.one_of({shallow ? 1 : 2, 2, 3, 4, 8, 16, 64})});
  }
  const std::size_t head = static_cast<std::size_t>(random.between(0, 2));
  const int late = random.chance(15) ? 1 : 0, misses = random.one_of({0, 3, 40}) != 0 ? 10 : 0;
  return random_records(std::move(graph), 900, random,
                        [&](std::size_t i) { return i == head ? Habits{15, 0, 60, 10, 10, misses} : Habits{late, 0, late, 3, 3, misses}; });
}

/// Hands the records of a case to a plane in random blocks of random stages. Returns false once all are handed out.
template <class Plane>
bool append_block(Plane& plane, const TimingCase& timing_case, std::vector<std::size_t>& used, Random& random) {
  const std::size_t stages = timing_case.records.size();
  const std::size_t first = static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(stages) - 1));
  for (std::size_t turn = 0; turn < stages; ++turn) {
    const std::size_t stage = (first + turn) % stages;
    const std::vector<TokenRecord>& records = timing_case.records[stage];
    if (used[stage] == records.size()) continue;
    const std::size_t left = records.size() - used[stage];
    const std::size_t count = std::min(left, static_cast<std::size_t>(random.between(1, random.one_of({1, 8, 300}))));
    plane.append(static_cast<int>(stage), records.data() + used[stage], count);
    used[stage] += count;
    return true;
  }
  return false;
}

}  // namespace bump::test
