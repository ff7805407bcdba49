#pragma once
// From a trace and a configuration to dates: rebuilds the netlists that the trace was recorded with, schedules them under the
// configuration, and dates the trace. Refuses configurations that differ from the recorded one in anything but timing, and a trace whose
// netlists the program no longer builds. No hardware.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "retiming/replay.h"
#include "system/simulation.h"

namespace bump {

/// What a run under another configuration would have said of time.
struct RetimedRun {
  TimingResult timing;
  Bound bound;
};

class Retimer {
 public:
  /// `parameters`: all that the program knows. Throws Error(input) if scheme, parameters or netlists are not those of the trace.
  Retimer(TimingTrace trace, Parameters parameters, const std::string& name);

  const TimingTrace& trace() const { return trace_; }
  /// The configuration of the recorded run.
  const Configuration& recorded() const { return recorded_; }
  /// Throws Error(input) at the first parameter that is not the recorded run's and is more than timing.
  void check(const Configuration& configuration) const;

  /// Of a configuration that check() accepts. Schedules are kept: only the first of many that agree in operators costs much.
  PipelineTiming timing_of(const Configuration& configuration);
  /// As above, and dated by the timeline. Throws Error(deadlock), and what `watch` throws.
  RetimedRun retime(const Configuration& configuration, const std::function<void(double)>& watch = {});

 private:
  TimingTrace trace_;
  std::string name_;
  Configuration recorded_;
  std::optional<TracedDesign> traced_;
  std::vector<std::string> schedule_keys_;              ///< parameters that schedules depend on
  std::map<std::string, DatapathSchedules> schedules_;  ///< by their values
};

}  // namespace bump
