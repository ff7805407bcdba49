#pragma once
// A bounded channel between the units of the functional plane. It carries blocks of fragments or triangles by ownership, so nothing is
// copied, and it has no timing: values run ahead of the clock, and the bounded FIFOs of the simulated hardware live in the timing plane
// (timing_graph.h). The capacity only bounds memory and keeps units working on neighbouring blocks. One writer, one reader, both SC_THREAD
// processes; what is read does not depend on the order in which processes are scheduled (a Kahn process network).

#include <deque>
#include <memory>
#include <string>
#include <systemc>
#include <utility>

#include "datapath/invariant.h"

namespace bump {

template <class T>
class BlockFifo : public sc_core::sc_prim_channel {
 public:
  /// capacity >= 1: blocks that wait between writer and reader.
  explicit BlockFifo(const std::string& name, std::size_t capacity = 2) : sc_prim_channel(name.c_str()), capacity_(capacity) {
    BUMP_ASSERT(capacity >= 1);
  }
  ~BlockFifo() override = default;

  /// Waits for room. The block must not be null and the channel not closed.
  void write(std::unique_ptr<T> block) {
    BUMP_ASSERT(block != nullptr && !closed_);
    while (blocks_.size() >= capacity_) sc_core::wait(read_event_);
    blocks_.push_back(std::move(block));
    written_event_.notify(sc_core::SC_ZERO_TIME);
  }

  /// Waits for a block; null once the channel is closed and empty.
  std::unique_ptr<T> read() {
    // The condition is tested again after every wake-up: a notification says only that something changed.
    while (blocks_.empty() && !closed_) sc_core::wait(written_event_);
    if (blocks_.empty()) return nullptr;
    std::unique_ptr<T> block = std::move(blocks_.front());
    blocks_.pop_front();
    read_event_.notify(sc_core::SC_ZERO_TIME);
    return block;
  }

  /// No more blocks will be written. Closing twice is harmless.
  void close() {
    closed_ = true;
    written_event_.notify(sc_core::SC_ZERO_TIME);
  }

  /// Blocks waiting now.
  std::size_t size() const { return blocks_.size(); }
  const char* kind() const override { return "BlockFifo"; }

 private:
  const std::size_t capacity_;
  std::deque<std::unique_ptr<T>> blocks_;
  bool closed_ = false;
  sc_core::sc_event written_event_, read_event_;
};

}  // namespace bump
