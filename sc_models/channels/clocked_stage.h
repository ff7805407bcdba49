#pragma once
// What the clocked engine asks of a stage, whatever is behind it: the model of a stage (stepped_stage.h), or hardware that stands in for
// it, such as translated Verilog. A stage acts at rising edges, on what its FIFOs' registered flags say, and is asked between edges.

#include <cstdint>
#include <functional>
#include <memory>
#include <systemc>
#include <vector>

#include "channels/stepped_control.h"
#include "channels/stepped_fifo.h"
#include "channels/stepped_memory.h"
#include "channels/untimed_replay.h"

namespace bump {

class ClockedStage {
 public:
  virtual ~ClockedStage() = default;

  virtual void append(const TokenRecord& record, std::int64_t count) = 0;
  /// More records must be appended before the next edge, unless there are none: to start from, or to know whether a token in flight is the
  /// last to give to an output.
  virtual bool wants_records() const = 0;
  /// Once a cycle, between edges: throws Error if the stage cannot go on.
  virtual void check() const {}

  virtual bool moved() const = 0;     ///< a token started or was delivered in the last cycle
  virtual bool counting() const = 0;  ///< a counter runs: something will happen without a neighbour's help
  virtual bool empty() const = 0;     ///< all tokens delivered
  virtual Cycle last_delivery() const = 0;
  virtual StageStatistics statistics() const = 0;
  virtual UntimedState::Stage untimed() const = 0;
  /// Adds what there is to see to a waveform.
  virtual void trace(sc_core::sc_trace_file* file) const = 0;
};

/// Where a stage stands in the engine; all of it outlives the stage.
struct StageParts {
  struct Output {
    SteppedFifo* fifo;
    bool needs_end;  ///< its consumer gathers batches, so the last item must be marked
  };
  const StageSpec& spec;
  std::vector<SteppedFifo*> inputs;
  std::vector<Output> outputs;
  SteppedMemory* memory;  ///< null: none
  SteppedControl& control;
};

/// Supplies a stage, or null for the model of it.
using StageFactory = std::function<std::unique_ptr<ClockedStage>(const StageParts&)>;

}  // namespace bump
