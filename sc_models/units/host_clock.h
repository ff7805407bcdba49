#pragma once
// How long the host works on a unit's behalf: the bottleneck of the simulator, not of the hardware. A module's clock runs while its unit
// works and stands still while the module waits for blocks, so the clocks of one run add up to the time spent in units. Two readings of
// the host's clock a block; never part of what a simulation computes.

#include <chrono>
#include <string>

namespace bump {

class HostClock {
 public:
  void start() { begin_ = Clock::now(); }
  void stop() { total_ += Clock::now() - begin_; }
  /// All spans between start() and stop().
  double seconds() const { return std::chrono::duration<double>(total_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_;
  Clock::duration total_{};
};

/// A part of the simulator's work, by the name of the module or of what is done.
struct HostTime {
  std::string part;
  double seconds = 0;
};

}  // namespace bump
