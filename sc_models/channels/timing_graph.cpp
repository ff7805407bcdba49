#include "channels/timing_graph.h"

#include <fmt/format.h>

#include <tuple>

#include "datapath/error.h"

namespace bump {

namespace {

/// Rings of dates are as long as a FIFO is deep, so depths and capacities are bounded by memory.
constexpr std::int64_t most_tokens = std::int64_t{1} << 24;
constexpr std::int64_t most_cycles = std::int64_t{1} << 32;
/// One bit each in the masks of TokenRecord.
constexpr std::size_t most_ports = 8;

void check_range(std::int64_t value, std::int64_t low, std::int64_t high, const std::string& what) {
  if (value >= low && value <= high) return;
  throw Error({fmt::format("{} is {}", what, value), {}, fmt::format("it must be from {} to {}", low, high), "set it within this range"});
}

void check_stage(const TimingGraph& graph, std::size_t index) {
  const StageSpec& stage = graph.stages[index];
  const std::string where = fmt::format(" of stage '{}'", stage.name);
  check_range(stage.latency, 1, most_cycles, "latency" + where);
  check_range(stage.capacity, 1, most_tokens, "capacity" + where);
  check_range(stage.batch, 1, most_tokens, "batch" + where);
  check_range(stage.memory, -1, static_cast<std::int64_t>(graph.memories.size()) - 1, "memory port" + where);
  const int stage_index = static_cast<int>(index);
  if (graph.inputs_of(stage_index).size() > most_ports || graph.outputs_of(stage_index).size() > most_ports)
    throw Error({fmt::format("stage '{}' has more than {} inputs or outputs", stage.name, most_ports),
                 {},
                 "a token's routing masks have one bit for each",
                 "split the stage"});
}

void check_fifo(const TimingGraph& graph, const FifoSpec& fifo) {
  const std::string where = fmt::format(" of FIFO '{}'", fifo.name);
  const std::int64_t last_stage = static_cast<std::int64_t>(graph.stages.size()) - 1;
  check_range(fifo.depth, 1, most_tokens, "depth" + where);
  check_range(fifo.from, 0, last_stage, "source stage" + where);
  check_range(fifo.to, 0, last_stage, "destination stage" + where);
  if (fifo.from >= fifo.to)
    throw Error({fmt::format("FIFO '{}' runs backwards, from stage {} to stage {}", fifo.name, fifo.from, fifo.to),
                 {},
                 "dates are resolved from earlier to later stages",
                 "order the stages along the flow of tokens"});
}

void check_memory(const MemorySpec& memory) {
  const std::string where = fmt::format(" of memory port '{}'", memory.name);
  check_range(memory.tag_latency, 1, most_cycles, "tag latency" + where);
  check_range(memory.latency, 1, most_cycles, "latency" + where);
  check_range(memory.cycles_per_line, 1, most_cycles, "cycles per line" + where);
  check_range(memory.outstanding, 1, most_tokens, "outstanding misses" + where);
}

/// Two stages on one port would have to arbitrate by date, which running ahead cannot do exactly.
void check_ports_unshared(const TimingGraph& graph) {
  std::vector<const StageSpec*> owner(graph.memories.size(), nullptr);
  for (const StageSpec& stage : graph.stages) {
    if (stage.memory < 0) continue;
    const StageSpec*& first = owner[static_cast<std::size_t>(stage.memory)];
    const std::string& port = graph.memories[static_cast<std::size_t>(stage.memory)].name;
    if (first != nullptr)
      throw Error({fmt::format("stages '{}' and '{}' share memory port '{}'", first->name, stage.name, port),
                   {},
                   "a port serves one stage, in token order",
                   "give each stage a port of its own"});
    first = &stage;
  }
}

}  // namespace

std::vector<int> TimingGraph::inputs_of(int stage) const {
  std::vector<int> found;
  for (std::size_t f = 0; f < fifos.size(); ++f)
    if (fifos[f].to == stage) found.push_back(static_cast<int>(f));
  return found;
}

std::vector<int> TimingGraph::outputs_of(int stage) const {
  std::vector<int> found;
  for (std::size_t f = 0; f < fifos.size(); ++f)
    if (fifos[f].from == stage) found.push_back(static_cast<int>(f));
  return found;
}

void TimingGraph::validate() const {
  for (const FifoSpec& fifo : fifos) check_fifo(*this, fifo);
  for (const MemorySpec& memory : memories) check_memory(memory);
  for (std::size_t i = 0; i < stages.size(); ++i) check_stage(*this, i);
  check_ports_unshared(*this);
}

bool operator==(const StageStatistics& a, const StageStatistics& b) {
  const auto all = [](const StageStatistics& s) {
    return std::tie(s.name, s.tokens, s.busy, s.starved, s.blocked_room, s.blocked_output, s.last_delivery);
  };
  return all(a) == all(b);
}

bool operator==(const FifoStatistics& a, const FifoStatistics& b) {
  const auto all = [](const FifoStatistics& f) {
    return std::tie(f.name, f.depth, f.items, f.max_occupancy, f.full_cycles, f.empty_cycles);
  };
  return all(a) == all(b);
}

bool operator==(const MemoryStatistics& a, const MemoryStatistics& b) {
  return std::tie(a.name, a.requests, a.busy) == std::tie(b.name, b.requests, b.busy);
}

bool operator==(const TimingResult& a, const TimingResult& b) {
  return std::tie(a.cycles, a.stages, a.fifos, a.memories) == std::tie(b.cycles, b.stages, b.fifos, b.memories);
}

void report_deadlock(const Deadlock& deadlock) {
  std::string chain;
  for (const Deadlock::Wait& wait : deadlock.chain) {
    if (!chain.empty()) chain += "; ";
    const std::string target = wait.fifo.empty() ? "room in flight" : fmt::format("{} at FIFO {}", wait.on, wait.fifo);
    chain += fmt::format("{} waits for {} ({})", wait.stage, target, wait.reason);
  }
  throw Error(ErrorKind::deadlock, {fmt::format("deadlock: nothing moves after cycle {}", deadlock.cycle), {}, chain, deadlock.remedy});
}

}  // namespace bump
