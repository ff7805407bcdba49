#pragma once
// The closed-form lower bound on the cycles of a run, and what binds. Every resource alone needs at least
//   stage              the sum of its initiation intervals (of which the last may end behind the last delivery: never more than the run)
//   capacity           tokens (L + 1) / C: room in flight is given back no sooner than L + 1 cycles after it was taken
//   FIFO               2 items / D: a slot takes two cycles to be filled and freed again
//   memory bandwidth   (requests - 1) x cycles per line + latency
//   outstanding misses requests (latency + 1) / M
// The largest binds. The bound leaves out the filling and draining of the pipeline and all interplay.

#include "channels/timing_graph.h"
#include "system/simulation.h"

namespace bump {

Bound lower_bound(const TimingGraph& graph, const TimingResult& result);

}  // namespace bump
