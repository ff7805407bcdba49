#pragma once
// An emitted unit as a stage of the clocked engine: its handshake decides when tokens start and are delivered, and the FIFOs around it are
// those of the models. At a rising edge what the unit has shown since the last one is sampled, tokens are popped and pushed accordingly,
// and the unit's own clock rises one delta cycle later; at the falling edge the unit is driven for the next cycle: in_valid and operands by
// the head of the input FIFO, out_ready by the room in the output FIFO. Statistics are counted from what the unit does, not from what it
// should do; beside that every cycle's in_ready and out_valid are held against the recurrences of the timing model. Reset is over before
// cycle 0.

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <vector>

#include "channels/clocked_stage.h"
#include "datapath/error.h"
#include "testbench/cosimulation/rtl_pins.h"

namespace bump {

/// The words of the tokens, in their order.
class TokenWords {
 public:
  virtual ~TokenWords() = default;
  /// Of the token that starts next.
  virtual const std::uint64_t* operands() = 0;
  virtual void started() = 0;
  virtual void delivered(const std::uint64_t* results) = 0;
};

/// What was seen of a unit's handshake.
struct HandshakeReport {
  std::int64_t tokens = 0;        ///< delivered
  std::int64_t wrong_cycles = 0;  ///< in which in_ready or out_valid were not what the recurrences say
  std::string first;              ///< what was wrong first, empty if nothing
};

class RtlStage : public sc_core::sc_module, public ClockedStage {
 public:
  /// A stage with one input and one output, without memory port and batches. `words` must outlive it.
  RtlStage(sc_core::sc_module_name name, const StageParts& parts, const std::function<std::unique_ptr<RtlPins>()>& make_pins,
           TokenWords& words);

  const RtlPins& pins() const { return *pins_; }
  HandshakeReport handshake() const;

  void append(const TokenRecord& record, std::int64_t count) override;
  bool wants_records() const override { return started_ == appended_; }
  /// Throws Error(self_check) when the unit has not moved a token for long though nothing keeps it from it.
  void check() const override;
  bool moved() const override { return moved_; }
  bool counting() const override;
  bool empty() const override { return started_ == appended_ && flights_.empty(); }
  Cycle last_delivery() const override { return statistics_.last_delivery; }
  StageStatistics statistics() const override;
  UntimedState::Stage untimed() const override;
  void trace(sc_core::sc_trace_file* file) const override;

 private:
  struct Flight {
    TokenRecord record;
    Cycle start;
  };

  void reset();
  void edge();
  void rise();
  void fall();
  void deliver(bool valid);
  void issue(bool ready);
  void compare(bool ready, bool valid);

  const StageSpec spec_;
  SteppedFifo &input_, &output_;
  SteppedControl& control_;
  const std::unique_ptr<RtlPins> pins_;
  TokenWords& words_;
  std::vector<std::uint64_t> results_;

  TokenRuns runs_;
  mutable TokenRuns::Cursor next_;
  std::int64_t appended_ = 0, started_ = 0;
  std::deque<Flight> flights_;  ///< oldest first
  Cycle interval_left_ = 0, cycle_ = 0;
  bool offered_ = false;  ///< in_valid
  bool moved_ = false;
  Cycle overdue_ = 0;  ///< cycles on end in which the unit should have moved a token and has not
  StageStatistics statistics_;
  HandshakeReport handshake_;
  // For waveforms.
  bool in_ready_ = false, out_valid_ = false;
  int in_flight_ = 0;
};

}  // namespace bump
