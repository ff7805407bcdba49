#include "system/bound.h"

#include <algorithm>
#include <cmath>

namespace bump {

namespace {

/// Of the stage that is busy longest. A chain that passes one fragment a cycle has many that are equally busy: then that is said.
Bound busiest_stage(const TimingGraph& graph, const TimingResult& result, const std::vector<Cycle>& last_interval) {
  Cycle busiest = -1, latency = 0;
  std::string first;
  int as_busy = 0;
  for (std::size_t i = 0; i < graph.stages.size(); ++i) {
    if (result.stages[i].tokens == 0) continue;
    const Cycle starts = result.stages[i].busy - last_interval[i];
    if (starts > busiest) {
      busiest = starts;
      latency = 0;
      first = graph.stages[i].name;
      as_busy = 0;
    }
    if (starts < busiest) continue;
    latency = std::max(latency, graph.stages[i].latency);
    ++as_busy;
  }
  if (busiest < 0) return {};
  const std::string others = as_busy > 1 ? " (and " + std::to_string(as_busy - 1) + " more stages)" : "";
  return {static_cast<double>(busiest + latency + 1), first + others + ": initiation interval"};
}

}  // namespace

Bound lower_bound(const TimingGraph& graph, const TimingResult& result, const std::vector<Cycle>& last_interval) {
  Bound bound = busiest_stage(graph, result, last_interval);
  const auto offer = [&](double busy, const std::string& by) {
    if (busy > bound.cycles) bound = {busy, by};
  };
  for (std::size_t i = 0; i < graph.stages.size(); ++i) {
    const StageSpec& spec = graph.stages[i];
    const StageStatistics& seen = result.stages[i];
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
  bound.cycles = std::ceil(bound.cycles);
  return bound;
}

}  // namespace bump
