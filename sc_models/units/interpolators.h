#pragma once
// The interpolators: one plane per component from the perspective-correct weights that come with each fragment, a0 + w1 (a1 - a0) +
// w2 (a2 - a0), angles wrapped to [-1/2, 1/2) turns; then, if the design has one, the conversion netlist (per light), in front of the
// texture unit. The interpolation itself is done in double precision: its word widths are left out, a value is rounded where a netlist
// reads it. Every component has its own adders and multipliers, one fragment a cycle; a conversion's time follows from its netlist. Source:
// Heckbert and Moreton, "Interpolation for polygon texture mapping and shading", 1991.

#include <memory>

#include "channels/parameters.h"
#include "units/datapath_unit.h"
#include "units/pipeline_context.h"

namespace bump {

struct InterpolatorsConfig {
  int latency = 4;  ///< cycles, beside those of the conversion netlist

  static void declare(Parameters& parameters);
  InterpolatorsConfig() = default;
  explicit InterpolatorsConfig(const Configuration& configuration);
};

/// The hardware of the interpolators: perspective weights from screen-space weights and 1 / w, then u, v and every component. Differences
/// between corners and the screen-space weights are triangle setup's and the rasterizer's work, so they are inputs.
Netlist interpolator_netlist(const PipelineContext& context);
/// Interpolated components besides u and v; flat ones count, probes do not.
int interpolator_components(const PipelineContext& context);

class Interpolators {
 public:
  explicit Interpolators(std::shared_ptr<const PipelineContext> context);
  void process(FragmentBlock& block);

  /// Executions of the conversion netlist: fragments times lights, 0 without one.
  std::int64_t conversions() const { return conversion_.executions(); }

 private:
  std::shared_ptr<const PipelineContext> context_;
  DatapathUnit conversion_;
};

}  // namespace bump
