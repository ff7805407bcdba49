#pragma once
// Work in processes of its own, several side by side: SystemC elaborates once per process, so every simulation of a comparison needs a
// process, and two cores are used as well. A child starts as a copy of the parent (what was read or drawn before need not be read again)
// and hands back bytes. The outcomes come in the order of the tasks, whatever the number of jobs. No model of hardware.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace bump {

/// What a child may call: its share of the work done, 0 to 1.
using ReportShare = std::function<void(double)>;

struct ChildTask {
  std::string name;  ///< for errors: "lee2007 on world_sphere"
  /// Runs in the child; what it returns arrives in the parent, of any length.
  std::function<std::string(const ReportShare& report_share)> work;
};

struct ChildOutcome {
  std::string bytes;
  std::optional<Error> error;  ///< what the work threw (kind and text kept); a child that died is Error(internal) naming signal or status
};

struct ChildOptions {
  int jobs = 0;                                  ///< children at a time; 0: one per core of this process
  std::function<void(double)> progress;          ///< mean share of all tasks, 0 to 1
  const std::atomic<bool>* cancelled = nullptr;  ///< when set, children are ended and Error(cancelled) is thrown
};

/// A child never outlives the call, neither does anything it leaves on disk. Call before this process elaborates SystemC or starts threads.
std::vector<ChildOutcome> run_in_children(const std::vector<ChildTask>& tasks, const ChildOptions& options);

}  // namespace bump
