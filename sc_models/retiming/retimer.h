#pragma once
// From a trace and a configuration to dates: rebuilds the netlists that the trace was recorded with, schedules them under the
// configuration, and dates the trace. Refuses configurations that differ from the recorded one in anything but timing, and a trace whose
// netlists the program no longer builds. No hardware.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "retiming/refetch.h"
#include "retiming/replay.h"
#include "system/simulation.h"

namespace bump {

/// What a run under another configuration would have said of time.
struct RetimedRun {
  TimingResult timing;
  Bound bound;
  std::optional<FetchTraffic> traffic;  ///< of traces with addresses
};

class Retimer {
 public:
  /// `parameters`: all that the program knows. Throws Error(input) if scheme, parameters or netlists are not those of the trace.
  Retimer(TimingTrace trace, Parameters parameters, const std::string& name);

  const TimingTrace& trace() const { return trace_; }
  /// The configuration of the recorded run.
  const Configuration& recorded() const { return recorded_; }
  /// Null for designs without light maps.
  const LightMaps* light_maps() const { return traced_->design.light_maps ? &*traced_->design.light_maps : nullptr; }
  /// Throws Error(input) at the first parameter that is not the recorded run's and is more than timing, or, with addresses, more than what
  /// caches find; and for caches that cannot be built.
  void check(const Configuration& configuration) const;

  /// Of a configuration that check() accepts. Schedules are kept: only the first of many that agree in operators costs much.
  PipelineTiming timing_of(const Configuration& configuration);
  /// Whether a parameter is one that needs addresses: cache geometry, what a fetch unit serves each cycle. Parameters of light maps in
  /// designs without are none.
  bool is_fetch_key(const std::string& key) const;
  /// Whether hits, misses or intervals of fetches can be others than those of the recorded run.
  bool fetches_anew(const Configuration& configuration) const;
  FetchSettings fetch_settings(const Configuration& configuration) const;
  /// Of a trace with addresses: the records and traffic of each of the settings, in their order. Throws Error(self_check) if the recorded
  /// run's settings do not give what was recorded. When `cancelled` (may be null) is set, the results are incomplete.
  std::vector<FetchedTrace> fetch(const std::vector<FetchSettings>& settings, const std::atomic<bool>* cancelled) const;
  /// As above, and dated by the timeline. Throws Error(deadlock), and what `watch` throws.
  RetimedRun retime(const Configuration& configuration, const std::function<void(double)>& watch = {});

 private:
  std::string command_again(const std::pair<std::string, std::string>& changed, const std::string& more = "") const;
  /// Of light maps, in a design without.
  bool is_unused(const std::string& key) const;

  TimingTrace trace_;
  std::string name_;
  Configuration recorded_;
  std::optional<TracedDesign> traced_;
  std::vector<std::string> fetch_keys_;                 ///< parameters that need addresses
  std::vector<std::string> schedule_keys_;              ///< parameters that schedules depend on
  std::map<std::string, DatapathSchedules> schedules_;  ///< by their values
};

}  // namespace bump
