#pragma once
// A bounded FIFO between two stages with registered flags: what a stage sees is the state at the beginning of the cycle, whatever its
// neighbour does in the same cycle. An item pushed in cycle t can be popped in t+1, a slot freed in t can be filled in t+1. Only counts are
// kept, as values travel in the functional plane; a mark on the last item of the stream lets a batch start that will not fill up. Takes one
// push and one pop a cycle.

#include <algorithm>
#include <systemc>

#include "channels/timing_graph.h"
#include "datapath/invariant.h"

namespace bump {

class SteppedFifo : public sc_core::sc_prim_channel {
 public:
  explicit SteppedFifo(const FifoSpec& spec) : sc_prim_channel(spec.name.c_str()), depth_(spec.depth) { statistics_.name = spec.name; }
  ~SteppedFifo() override = default;

  std::int64_t occupancy() const { return occupancy_; }
  bool has_room() const { return ready_; }
  /// The last item of the stream has been pushed.
  bool ends() const { return ends_; }

  void push(bool last) {
    BUMP_ASSERT(ready_ && !pushed_);
    pushed_ = true;
    last_ = last;
    request_update();
  }
  void pop() {
    BUMP_ASSERT(valid_ && !popped_);
    popped_ = true;
    request_update();
  }

  /// Counts this cycle; once a cycle.
  void sample() {
    statistics_.max_occupancy = std::max<std::int64_t>(statistics_.max_occupancy, occupancy_);
    if (!ready_) ++statistics_.full_cycles;
    if (!valid_) ++statistics_.empty_cycles;
  }
  FifoStatistics statistics() const {
    FifoStatistics result = statistics_;
    result.depth = depth_;
    result.items = written_;
    return result;
  }
  std::int64_t written() const { return written_; }
  std::int64_t released() const { return written_ - occupancy_; }

  void trace(sc_core::sc_trace_file* file) const override {
    const std::string prefix = name();
    sc_core::sc_trace(file, occupancy_, prefix + ".occupancy");
    sc_core::sc_trace(file, valid_, prefix + ".valid");
    sc_core::sc_trace(file, ready_, prefix + ".ready");
  }
  const char* kind() const override { return "SteppedFifo"; }

 protected:
  void update() override {
    written_ += pushed_;
    occupancy_ += static_cast<int>(pushed_) - static_cast<int>(popped_);
    ends_ |= pushed_ && last_;
    valid_ = occupancy_ > 0;
    ready_ = occupancy_ < depth_;
    pushed_ = popped_ = false;
  }

 private:
  const std::int64_t depth_;
  // Registers.
  sc_dt::int64 occupancy_ = 0;
  bool valid_ = false, ready_ = true, ends_ = false;
  std::int64_t written_ = 0;
  // What happens in this cycle.
  bool pushed_ = false, popped_ = false, last_ = false;
  FifoStatistics statistics_;
};

}  // namespace bump
