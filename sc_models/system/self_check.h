#pragma once
// What must hold in every run, whatever the scene and the configuration. A violation is a fault of the program that the user must hear of: it ends the
// run with exit code 4 and no result is written.

#include "channels/timing_graph.h"
#include "system/simulation.h"

namespace bump {

/// Fragments in = fragments retired; covered = hidden + shaded; every FIFO's items went in and came out; tokens of neighbouring stages
/// agree; hits + misses = look-ups = memory requests + hits; every fragment reads every light map once; counters fit into the run; the
/// bound is not beaten. Throws Error(self_check). `last_interval`: initiation interval of the last token of each stage, which may end
/// behind the run.
void check_conservation(const SimulationResult& result, const TimingGraph& graph, const std::vector<Cycle>& last_interval);

}  // namespace bump
