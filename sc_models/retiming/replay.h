#pragma once
// Dates a trace anew with the ordinary timing plane, for any configuration: batches, deep FIFOs, everything. As exact as a run, since the
// same records go through the same recurrences. No hardware.

#include <functional>
#include <vector>

#include "retiming/timing_trace.h"
#include "system/pipeline_timing.h"

namespace bump {

struct Retimed {
  TimingResult timing;
  std::vector<Cycle> last_interval;  ///< by stage: initiation interval of the last token
};

/// `watch` is called with the share that is done, 0 to 1, now and then; it may throw to end the work. Throws Error(deadlock) as a run does.
Retimed replay(const TimingTrace& trace, const PipelineTiming& timing, const std::function<void(double)>& watch = {});

/// The record that a stage's token has under a configuration: light-map fetch takes at least as long as its address.
TokenRecord record_under(const TokenRecord& record, traced::Index stream, const PipelineTiming& timing);

/// Kind of the stage that a stream belongs to.
stage::Index stage_of(traced::Index stream);

}  // namespace bump
