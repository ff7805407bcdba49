#pragma once
// From a state in which nothing moves to a report that a user can act on: the cycle of stages that wait for one another, and the smallest
// change of one depth or capacity that lets every token through, found by replaying the state (untimed_replay.h). Both engines use it on
// their own state.

#include "channels/timing_graph.h"
#include "channels/untimed_replay.h"

namespace bump {

/// Throws Error(self_check) when a FIFO will be given more or fewer items than are removed from it: records of two stages contradict
/// each other, which no depth can mend.
void require_matching_items(const TimingGraph& graph, const UntimedState& state);

/// `state`: tokens remain, none can move; the records in it are all that will come. `cycle`: the last one in which anything moved.
Deadlock analyse_deadlock(const TimingGraph& graph, const UntimedState& state, Cycle cycle);

}  // namespace bump
