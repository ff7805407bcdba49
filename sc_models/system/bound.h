#pragma once
// The closed-form lower bound on the cycles of a run, and what binds. Every resource alone needs at least
//   stage              the sum of its initiation intervals but the last, and the latency behind the last start
//   capacity           tokens (L + 1) / C: room in flight is given back no sooner than L + 1 cycles after it was taken
//   FIFO               2 items / D: a slot takes two cycles to be filled and freed again
//   memory bandwidth   (requests - 1) x cycles per line + latency
//   outstanding misses requests (latency + 1) / M
// The largest binds. The bound leaves out the filling and draining of the pipeline and all interplay.

#include "channels/timing_graph.h"
#include "system/simulation.h"

namespace bump {

/// `last_interval`: initiation interval of the last token of each stage, 0 without tokens.
Bound lower_bound(const TimingGraph& graph, const TimingResult& result, const std::vector<Cycle>& last_interval);

}  // namespace bump
