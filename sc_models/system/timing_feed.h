#pragma once
// The way from the functional plane to the timing plane: the timing records of a retired block of fragments.

#include <memory>

#include "channels/timing_plane.h"
#include "system/pipeline_timing.h"
#include "units/fragment_block.h"

namespace bump {

struct TimingRecords {
  TokenRecords vertex, setup, raster, texture, light_map;
  int fragments = 0;  ///< tokens of the stages whose tokens are all alike
};

/// A copy of the records that the block carries.
std::unique_ptr<TimingRecords> records_of(const FragmentBlock& block);

/// Appends the records, stage by stage, and notes the initiation interval of the last token of each stage of the graph.
void feed(TimingPlane& plane, const TimingRecords& records, const PipelineTiming& timing, std::vector<Cycle>& last_interval);

}  // namespace bump
