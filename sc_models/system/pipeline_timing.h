#pragma once
// The timing attributes of the pipeline: a chain of eight stages joined by bounded FIFOs, with a memory port behind the texture unit. Latencies and
// initiation intervals of the datapath stages come from the schedules of their netlists; everything else from the configuration.
// Tokens are triangles in the first two stages, fragments from the rasterizer on.

#include <array>

#include "channels/parameters.h"
#include "channels/timing_graph.h"
#include "datapath/schedule.h"
#include "schemes/scheme.h"

namespace bump {

namespace stage {
enum Index : int {
  vertex_processor,
  triangle_setup,
  rasterizer,
  interpolators,
  texture_fetch,
  environment,
  illumination,
  frame_sink,
  count
};
}

const char* stage_name(int index);

/// Schedules of the per-pixel netlists, one execution each.
struct DatapathSchedules {
  Schedule conversion;  ///< without nodes when the design has none
  Schedule environment;
  Schedule illumination;
  Schedule colour;
};

struct PipelineTiming {
  TimingGraph graph;
  DatapathSchedules schedules;
  /// Initiation interval of the stages whose tokens are all alike (fragments from the interpolators on, but for the texture unit).
  std::array<std::uint32_t, stage::count> interval{};
};

/// Keys: fifos.*, memory.*, datapath.latency.*, environment.*, illumination.*, clock.*, numeric.
void declare_pipeline_parameters(Parameters& parameters);

/// The schedules of a design under the configured operator latencies and multiplier limits.
DatapathSchedules make_schedules(const Design& design, const Netlist& colour, const Configuration& configuration);

/// `lights` >= 1: the per-pixel netlists run once per light, one after another.
PipelineTiming make_pipeline_timing(const DatapathSchedules& schedules, int lights, const Configuration& configuration);

}  // namespace bump
