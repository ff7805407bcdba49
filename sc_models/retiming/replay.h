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

}  // namespace bump
