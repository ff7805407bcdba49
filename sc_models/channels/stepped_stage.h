#pragma once
// One stage of the pipeline, clocked: an issue side with an initiation-interval counter and credits for the tokens in flight, a pipeline
// that counts every token's latency down, and an in-order completion queue with one output port. In each cycle the oldest token is
// delivered if it is finished and every FIFO it gives to has room, and one token starts if the unit is free, its inputs hold what it needs,
// and a credit is left. All of that is decided from registered state. Values are not computed here: each token only has a timing record.

#include <deque>
#include <systemc>
#include <vector>

#include "channels/clocked_stage.h"

namespace bump {

class SteppedStage : public sc_core::sc_module, public ClockedStage {
 public:
  SteppedStage(sc_core::sc_module_name name, const StageParts& parts);

  void append(const TokenRecord& record, std::int64_t count) override;
  bool wants_records() const override;

  bool moved() const override { return moved_; }
  bool counting() const override;
  bool empty() const override;
  Cycle last_delivery() const override { return statistics_.last_delivery; }
  StageStatistics statistics() const override;
  UntimedState::Stage untimed() const override;
  void trace(sc_core::sc_trace_file* file) const override;

 private:
  struct Flight {
    TokenRecord record;
    Cycle left;          ///< cycles until its latency has passed
    sc_dt::int64 fills;  ///< lines that the memory must have filled
  };
  struct Port {
    StageParts::Output output;
    std::int64_t last_giver;  ///< the last known token that gives to it, -1 for none
  };
  enum class Issue { idle, busy, starved, blocked };

  void step();
  void deliver();
  Issue issue(std::size_t in_flight);
  bool inputs_ready(const TokenRecord& record) const;
  void start(const TokenRecord& record);

  const StageSpec spec_;
  const std::vector<SteppedFifo*> inputs_;
  std::vector<Port> outputs_;
  SteppedMemory* const memory_;
  SteppedControl& control_;

  TokenRuns runs_;
  mutable TokenRuns::Cursor next_;  ///< the token that starts next
  std::int64_t appended_ = 0, started_ = 0;
  std::deque<Flight> flights_;  ///< oldest first
  Cycle interval_left_ = 0;     ///< further cycles of the initiation interval
  sc_dt::int64 asked_ = 0;      ///< lines asked from the memory
  Cycle cycle_ = 0;
  bool moved_ = false;
  StageStatistics statistics_;
  // For waveforms.
  int state_ = 0, in_flight_ = 0;
  bool busy_ = false, output_blocked_ = false;
};

}  // namespace bump
