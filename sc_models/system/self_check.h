#pragma once
// What must hold in every run, whatever the scene and the configuration. A violation is a fault of the program that the user must hear of: it ends the
// run with exit code 4 and no result is written.

#include "channels/timing_graph.h"
#include "system/simulation.h"

namespace bump {

/// Fragments in = fragments retired; covered = hidden + shaded; every FIFO's items went in and came out; tokens of neighbouring stages agree; hits + misses =
/// look-ups = memory requests + hits; counters fit into the run; the bound is not beaten. Throws Error(self_check).
void check_conservation(const SimulationResult& result, const TimingGraph& graph);

}  // namespace bump
