#pragma once
// Makes the picture of intensities as a translated illumination unit delivers them: the colour unit's netlist behind it, and the depth test
// of the frame sink, in the order of the tokens. Their time is in the stages of the clocked engine.

#include <array>
#include <deque>
#include <memory>
#include <vector>

#include "datapath/evaluate.h"
#include "units/colour_unit.h"
#include "units/frame_buffer.h"
#include "units/pipeline_context.h"

namespace bump {

class IntensityPainter {
 public:
  IntensityPainter(std::shared_ptr<const PipelineContext> context, const ColourUnitConfig& config);

  /// The fragments of a block, before the intensity of any of them arrives.
  void add(const FragmentBlock& block);
  /// The intensity of the next fragment.
  void paint(double intensity);
  /// Everything painted so far; every fragment must have been.
  FrameBuffer finish();

 private:
  struct Fragment {
    std::int32_t x, y;
    int object;
    double depth;
    std::array<double, 3> texel;
  };
  void flush();

  std::shared_ptr<const PipelineContext> context_;
  std::vector<std::unique_ptr<Netlist>> netlists_;      ///< one per object
  std::vector<std::unique_ptr<Evaluator>> evaluators_;  ///< one per object
  std::deque<Fragment> waiting_;                        ///< for their intensities
  std::vector<Fragment> lit_;                           ///< of one object, a block at most
  std::vector<double> intensities_;                     ///< of `lit_`
  FrameBuffer frame_;
};

}  // namespace bump
