#pragma once
// What a run of a scene executed, as far as prices need it: how often each netlist ran, and what the fetch units moved. Each scheme runs
// in a process of its own. Counts come from the simulation; no time is used.

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "datapath/error.h"
#include "schemes/scheme.h"

namespace bump {

struct SimulationResult;

struct ExecutedWork {
  std::int64_t fragments = 0;
  std::map<std::string, std::int64_t> executions;  ///< by unit, as UnitCost calls them
  std::int64_t texture_look_ups = 0, texture_bytes = 0;
  std::int64_t light_map_look_ups = 0, light_map_bytes = 0;
  std::int64_t light_map_bytes_written = 0;  ///< once a frame
};

ExecutedWork work_of(const SimulationResult& result);

struct WorkOutcome {
  std::optional<ExecutedWork> work;
  std::optional<Error> error;
};

struct WorkOptions {
  int jobs = 0;  ///< 0: one per core; the outcome does not depend on it
  std::function<void(double)> progress;
  const std::atomic<bool>* cancelled = nullptr;
};

/// One outcome a scheme, in their order. Call before this process elaborates SystemC. Throws Error(cancelled).
std::vector<WorkOutcome> executed_work(const Scene& scene, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
                                       const WorkOptions& options);

}  // namespace bump
