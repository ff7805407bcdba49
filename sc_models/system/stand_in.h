#pragma once
// Hardware that stands in for the models of stages in the clocked engine: it decides in their place when tokens start and are delivered,
// and what it makes of the values becomes the picture. The functional plane runs as ever and feeds it. No hardware of its own.

#include <memory>

#include "channels/clocked_stage.h"
#include "system/pipeline_timing.h"
#include "units/fragment_block.h"
#include "units/frame_buffer.h"
#include "units/pipeline_context.h"

namespace bump {

class StandIn {
 public:
  virtual ~StandIn() = default;
  /// Once, before anything else. The timing outlives the simulation. May throw Error(input).
  virtual void prepare(std::shared_ptr<const PipelineContext> context, const PipelineTiming& timing) = 0;
  /// Asked for every stage of the graph, in order; null: its model.
  virtual std::unique_ptr<ClockedStage> stage(const StageParts& parts) = 0;
  /// Shown every block that the functional plane has drawn, with all its planes, before the engine learns of its tokens.
  virtual void retire(const FragmentBlock& block) = 0;
  /// After the simulation: replaces what its hardware drew in the frame of the models.
  virtual void draw(FrameBuffer& frame) = 0;
};

}  // namespace bump
