#pragma once
// The colour unit, the same for every scheme: the sum of the lights' intensities, plus ambient, times the colour texel, clamped to [0, 1].
// A netlist of its own behind the illumination unit, fully pipelined. Rounding to display bits is the frame writer's. Source: Lee 2007 Eq
// 2, with the material colour taken from a texture.

#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "units/pipeline_context.h"

namespace bump {

struct ColourUnitConfig {
  int bits = 12;  ///< fraction bits of intensities, texels and colours

  static void declare(Parameters& parameters);
  ColourUnitConfig() = default;
  explicit ColourUnitConfig(const Configuration& configuration);
};

/// How the lights' intensities reach the colour unit.
enum class LightSum {
  in_colour_unit,  ///< one by one, without the lights' own intensities
  in_light_maps    ///< as one sum that light maps hold, intensities included
};

/// Inputs "intensity" of every light (plane_of_light), or one "intensity" from light maps, and tex.r/g/b; outputs colour.r/g/b. A
/// multiplier per light for its intensity only if any light's differs from 1, none with light maps. Integer bits hold the brightest sum of
/// the scene's materials and lights.
Netlist colour_netlist(const Scene& scene, const Material& material, const ColourUnitConfig& config,
                       LightSum lights = LightSum::in_colour_unit);

class ColourUnit {
 public:
  ColourUnit(std::shared_ptr<const PipelineContext> context, const ColourUnitConfig& config);
  void process(FragmentBlock& block);

  /// The netlist of the first object; others differ in constants only.
  const Netlist& netlist() const { return *netlists_.front(); }
  std::int64_t executions() const { return executions_; }

 private:
  std::shared_ptr<const PipelineContext> context_;
  std::vector<std::unique_ptr<Netlist>> netlists_;            ///< one per object
  std::vector<std::unique_ptr<Evaluator>> hardware_, exact_;  ///< one per object
  std::vector<int> inputs_, outputs_;                         ///< planes in the order of ports
  std::int64_t executions_ = 0;
};

}  // namespace bump
