#include "retiming/replay.h"

#include "channels/timeline.h"
#include "retiming/trace_feeder.h"

namespace bump {

Retimed replay(const TimingTrace& trace, const PipelineTiming& timing, const std::function<void(double)>& watch) {
  TraceFeeder feeder(trace, timing);
  Timeline timeline(timing.graph);
  while (!feeder.at_end()) {
    feeder.append_slice(timeline);
    timeline.advance();
    if (watch) watch(feeder.share());
  }
  Retimed result;
  result.timing = timeline.finish();
  result.last_interval = feeder.last_interval();
  return result;
}

}  // namespace bump
