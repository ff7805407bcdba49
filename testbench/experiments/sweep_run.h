#pragma once
// Runs a sweep: whatever its journal does not have yet, in child processes; then writes the tables. A sweep that was ended, however, goes
// on where it stopped. No model of hardware.

#include <atomic>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/experiments/sweep_plan.h"

namespace bump {

/// How many of the points that are dated again are run in full as well: a number, or a share of them.
struct CheckShare {
  double value = 3;
  bool is_percent = false;
};
/// "3", "5%", "all". Throws Error(input).
CheckShare check_share_of(const std::string& text);
/// "2/3": the second of three. Throws Error(input).
Shard shard_of(const std::string& text);

struct SweepRunOptions {
  std::string out;  ///< folder
  std::string version;
  int jobs = 0;       ///< processes side by side; 0: one per core
  bool anew = false;  ///< forget what the journal has
  Shard shard;
  CheckShare check;
  std::function<void(double)> progress;
  const std::atomic<bool>* cancelled = nullptr;
};

struct SweepSummary {
  std::size_t points = 0;  ///< of this shard
  std::size_t known = 0;   ///< of them, from the journal
  std::size_t runs = 0, dated = 0, checked = 0;
  std::map<std::string, std::size_t> statuses;
  std::vector<std::string> damages;  ///< lines of the journal that do not count; their points ran again
  nlohmann::ordered_json manifest;
};

/// Call before this process elaborates SystemC or starts threads. Throws Error(cancelled), keeping what is finished; Error(self_check),
/// naming the point, if a full run says something else than re-timing; Error(input) if the folder cannot be used.
SweepSummary run_sweep(const SweepPlan& plan, const SweepRunOptions& options);

}  // namespace bump
