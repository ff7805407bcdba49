#include "direct_evaluation.h"

namespace bump::test {

DirectEvaluation::DirectEvaluation(const TimingCase& timing_case) : case_(timing_case), fifos_(timing_case.graph.fifos.size()) {
  for (std::size_t i = 0; i < case_.records.size(); ++i) {
    const std::vector<int> inputs = case_.graph.inputs_of(static_cast<int>(i));
    const std::vector<int> outputs = case_.graph.outputs_of(static_cast<int>(i));
    std::vector<Token> tokens;
    std::vector<std::int64_t> missers;
    for (const TokenRecord& record : case_.records[i]) {
      Token token;
      const std::int64_t k = static_cast<std::int64_t>(tokens.size());
      token.record = record;
      for (std::size_t j = 0; j < inputs.size(); ++j) {
        Fifo& fifo = fifos_[static_cast<std::size_t>(inputs[j])];
        if ((record.take >> j) & 1U) token.takes.push_back({inputs[j], static_cast<std::int64_t>(fifo.removers.size())});
        if ((record.release >> j) & 1U) fifo.removers.push_back(k);
      }
      for (std::size_t j = 0; j < outputs.size(); ++j) {
        Fifo& fifo = fifos_[static_cast<std::size_t>(outputs[j])];
        if (((record.give >> j) & 1U) == 0) continue;
        token.gives.push_back({outputs[j], static_cast<std::int64_t>(fifo.givers.size())});
        fifo.givers.push_back(k);
      }
      token.first_miss = static_cast<std::int64_t>(missers.size());
      missers.insert(missers.end(), record.misses, k);
      tokens.push_back(token);
    }
    tokens_.push_back(std::move(tokens));
    grants_.push_back(std::vector<Cycle>(missers.size(), unknown));
    missers_.push_back(std::move(missers));
  }
}

template <class Compute>
Cycle DirectEvaluation::memoised(Cycle& date, Compute compute) {
  if (date == in_progress) throw Cyclic();
  if (date != unknown) return date;
  date = in_progress;
  return date = compute();
}

Cycle DirectEvaluation::free(int stage, std::int64_t k) {
  return k == 0 ? 0 : start(stage, k - 1) + token(stage, k - 1).record.interval;
}

Cycle DirectEvaluation::arrived(int stage, std::int64_t k) {
  Cycle date = 0;
  const std::int64_t batch = spec_of_stage(stage).batch;
  for (const auto& [fifo, item] : token(stage, k).takes) {
    const std::int64_t items = static_cast<std::int64_t>(fifos_[static_cast<std::size_t>(fifo)].givers.size());
    const std::int64_t needed = k % batch == 0 ? std::min(item + batch, items) - 1 : item;
    // In a FIFO shallower than the batch the needed item waits for this very token: the date depends on itself.
    date = std::max(date, written(fifo, needed) + 1);
  }
  return date;
}

Cycle DirectEvaluation::start(int stage, std::int64_t k) {
  return memoised(token(stage, k).start, [&] {
    const std::int64_t capacity = spec_of_stage(stage).capacity;
    const Cycle room = k < capacity ? 0 : delivery(stage, k - capacity) + 1;
    return std::max({free(stage, k), arrived(stage, k), room});
  });
}

Cycle DirectEvaluation::grant(int stage, std::int64_t miss) {
  return memoised(grants_[static_cast<std::size_t>(stage)][static_cast<std::size_t>(miss)], [&] {
    const MemorySpec& memory = case_.graph.memories[static_cast<std::size_t>(spec_of_stage(stage).memory)];
    Cycle date = start(stage, missers_[static_cast<std::size_t>(stage)][static_cast<std::size_t>(miss)]) + memory.tag_latency;
    if (miss >= 1) date = std::max(date, grant(stage, miss - 1) + memory.cycles_per_line);
    if (miss >= memory.outstanding) date = std::max(date, grant(stage, miss - memory.outstanding) + memory.latency + 1);
    return date;
  });
}

Cycle DirectEvaluation::ready(int stage, std::int64_t k) {
  const Token& t = token(stage, k);
  Cycle date = start(stage, k) + t.record.lead + spec_of_stage(stage).latency;
  if (t.record.misses > 0) {
    const MemorySpec& memory = case_.graph.memories[static_cast<std::size_t>(spec_of_stage(stage).memory)];
    date = std::max(date, grant(stage, t.first_miss + t.record.misses - 1) + memory.latency + 1);
  }
  return k == 0 ? date : std::max(date, delivery(stage, k - 1) + 1);
}

Cycle DirectEvaluation::delivery(int stage, std::int64_t k) {
  return memoised(token(stage, k).delivery, [&] {
    Cycle date = ready(stage, k);
    for (const auto& [fifo, item] : token(stage, k).gives)
      if (item >= spec(fifo).depth) date = std::max(date, removed(fifo, item - spec(fifo).depth) + 1);
    return date;
  });
}

FifoStatistics DirectEvaluation::count(int fifo, Cycle cycles) {
  const Fifo& f = fifos_[static_cast<std::size_t>(fifo)];
  FifoStatistics result{spec(fifo).name, spec(fifo).depth, static_cast<std::int64_t>(f.givers.size()), 0, 0, 0};
  std::vector<std::int64_t> change(static_cast<std::size_t>(cycles) + 2, 0);
  for (std::int64_t item = 0; item < result.items; ++item) {
    ++change[static_cast<std::size_t>(written(fifo, item) + 1)];
    --change[static_cast<std::size_t>(removed(fifo, item) + 1)];
  }
  std::int64_t held = 0;
  for (Cycle cycle = 0; cycle < cycles; ++cycle) {
    held += change[static_cast<std::size_t>(cycle)];
    result.max_occupancy = std::max(result.max_occupancy, held);
    result.full_cycles += held == result.depth;
    result.empty_cycles += held == 0;
  }
  return result;
}

TimingResult DirectEvaluation::evaluate() {
  TimingResult result;
  for (int i = 0; i < static_cast<int>(tokens_.size()); ++i) {
    StageStatistics sums;
    sums.name = spec_of_stage(i).name;
    const std::int64_t count = static_cast<std::int64_t>(tokens_[static_cast<std::size_t>(i)].size());
    for (std::int64_t k = 0; k < count; ++k) {
      const Cycle able = std::max(free(i, k), arrived(i, k));
      ++sums.tokens;
      sums.busy += token(i, k).record.interval;
      sums.starved += able - free(i, k);
      sums.blocked_room += start(i, k) - able;
      sums.blocked_output += delivery(i, k) - ready(i, k);
      sums.last_delivery = delivery(i, k);
    }
    result.cycles = std::max(result.cycles, sums.last_delivery + 1);
    result.stages.push_back(sums);
    const int memory = spec_of_stage(i).memory;
    if (memory < 0) continue;
    const std::int64_t requests = static_cast<std::int64_t>(missers_[static_cast<std::size_t>(i)].size());
    const MemorySpec& port = case_.graph.memories[static_cast<std::size_t>(memory)];
    result.memories.push_back({port.name, requests, requests * port.cycles_per_line});
  }
  for (int f = 0; f < static_cast<int>(fifos_.size()); ++f) result.fifos.push_back(count(f, result.cycles));
  return result;
}

std::optional<TimingResult> DirectEvaluation::result() {
  try {
    return evaluate();
  } catch (const Cyclic&) {
    return std::nullopt;
  }
}

}  // namespace bump::test
