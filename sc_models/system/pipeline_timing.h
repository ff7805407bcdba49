#pragma once
// The timing attributes of the pipeline: a chain of stages joined by bounded FIFOs, with a memory port behind the texture unit. Designs
// with light maps have one stage more, light_map_fetch, with a memory port of its own; its FIFOs take the place of
// environment_to_illumination. Latencies and initiation intervals of the datapath stages come from the schedules of their netlists;
// everything else from the configuration. Tokens are triangles in the first two stages, fragments from the rasterizer on.

#include <array>

#include "channels/parameters.h"
#include "channels/timing_graph.h"
#include "datapath/schedule.h"
#include "schemes/scheme.h"

namespace bump {

/// The kinds of stages, in the order of the chain. Which of them a design has, and where in the graph, says PipelineTiming.
namespace stage {
enum Index : int {
  vertex_processor,
  triangle_setup,
  rasterizer,
  interpolators,
  texture_fetch,
  environment,
  light_map_fetch,  ///< only of designs with light maps
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
  Schedule light_map_address;  ///< without nodes when the design has no light maps
  Schedule illumination;
  Schedule colour;
};

struct PipelineTiming {
  TimingGraph graph;
  DatapathSchedules schedules;
  /// By kind: initiation interval of the stages whose tokens are all alike (fragments from the interpolators on, but for the texture unit);
  /// of light_map_fetch the least interval of a token, what its address takes.
  std::array<std::uint32_t, stage::count> interval{};
  /// By kind: index of the stage in the graph; -1 if the design has none.
  std::array<int, stage::count> place{};

  /// The stage of a kind that the design has.
  const StageSpec& at(stage::Index kind) const { return graph.stages[static_cast<std::size_t>(place[kind])]; }
};

/// Keys: fifos.*, datapath.latency.*, environment.*, illumination.*, clock.*, numeric.
void declare_pipeline_parameters(Parameters& parameters);

/// The configured cycles of operators, datapath.latency.*.
OperatorLatencies operator_latencies(const Configuration& configuration);

/// The schedules of a design under the configured operator latencies and multiplier limits.
DatapathSchedules make_schedules(const Design& design, const Netlist& colour, const Configuration& configuration);

/// `passes` >= 1: the per-pixel netlists run so often for each fragment, one execution after another: once per light, or once with light
/// maps.
PipelineTiming make_pipeline_timing(const DatapathSchedules& schedules, int passes, const Configuration& configuration);

}  // namespace bump
