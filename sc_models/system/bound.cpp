#include "system/bound.h"

namespace bump {

Bound lower_bound(const TimingGraph& graph, const TimingResult& result, const std::vector<Cycle>& last_interval) {
  Bound bound;
  const auto offer = [&](double busy, const std::string& by) {
    if (busy > bound.cycles) bound = {busy, by};
  };
  for (std::size_t i = 0; i < graph.stages.size(); ++i) {
    const StageSpec& spec = graph.stages[i];
    const StageStatistics& seen = result.stages[i];
    if (seen.tokens > 0) offer(static_cast<double>(seen.busy - last_interval[i] + spec.latency + 1), spec.name + ": initiation interval");
    offer(static_cast<double>(seen.tokens) * static_cast<double>(spec.latency + 1) / static_cast<double>(spec.capacity),
          spec.name + ": capacity in flight");
  }
  for (std::size_t i = 0; i < graph.fifos.size(); ++i)
    offer(2.0 * static_cast<double>(result.fifos[i].items) / static_cast<double>(graph.fifos[i].depth), "fifos." + graph.fifos[i].name + ": depth");
  for (std::size_t i = 0; i < graph.memories.size(); ++i) {
    const MemorySpec& spec = graph.memories[i];
    const MemoryStatistics& seen = result.memories[i];
    if (seen.requests > 0) offer(static_cast<double>((seen.requests - 1) * spec.cycles_per_line + spec.latency), spec.name + ": bandwidth");
    offer(static_cast<double>(seen.requests) * static_cast<double>(spec.latency + 1) / spec.outstanding, spec.name + ": outstanding misses");
  }
  return bound;
}

}  // namespace bump
