#pragma once
// One recorded trace dated under many configurations, several threads side by side: a row for each point of a grid. The rows do not depend
// on the number of threads. No model of hardware.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "retiming/retimer.h"
#include "testbench/experiments/retime_grid.h"

namespace bump {

struct SweepRow {
  std::vector<StageStatistics> stages;  ///< empty if it failed
  Cycle cycles = 0;
  Bound bound;
  double clock_megahertz = 100;
  std::optional<Error> error;           ///< deadlock, or a graph that cannot be built
  std::optional<FetchTraffic> traffic;  ///< of sweeps over what caches find
};

struct SweepOptions {
  int jobs = 0;                                  ///< threads; 0: one per core
  bool vectors = true;                           ///< date several configurations at once where that can be done
  std::function<void(double)> progress;          ///< share of the points, 0 to 1
  const std::atomic<bool>* cancelled = nullptr;  ///< when set, the sweep ends with Error(cancelled)
};

/// Whether any point's caches can find other than the recorded run's did: rows have traffic then.
bool sweeps_caches(const Retimer& retimer, const Configuration& base, const SweepGrid& grid);

/// Rows in the order of the points. `base` holds what the grid does not set; the result of check() is the caller's to ask for.
std::vector<SweepRow> sweep(Retimer& retimer, const Configuration& base, const SweepGrid& grid, const SweepOptions& options);

/// Points that are no full product.
struct SweepPoints {
  std::size_t count = 0;
  /// Sets everything that differs between points, in a configuration that may hold those of another point.
  std::function<void(std::size_t point, Configuration& configuration)> apply;
  bool with_caches = false;  ///< caches may find other than the recorded run's did; needs a trace with addresses
};
/// As above. Throws what Retimer::timing_of() and fetch() throw, without a row of it.
std::vector<SweepRow> sweep(Retimer& retimer, const Configuration& base, const SweepPoints& points, const SweepOptions& options);

/// --record FILE of a run: complete or not at all, as output_file.h says. Throws Error(input) if FILE lies in the result folder `out`.
void check_record_file(const std::string& path, const std::string& out, bool force);

}  // namespace bump
