#pragma once
// The quick way through a pipeline: takes tokens through a whole chain of stages, all stages of one token before the next token, so that
// a date is at hand where it is needed next; what is counted is summed afterwards, FIFO by FIFO, in loops that a compiler makes vectors of.
// It dates with the same recurrences as DatedStage, and can hand its state back to the stages at any time. A chain is the end of a graph in
// which each stage feeds nothing but the next, without batches; behind its first stage, the head, every token takes and removes one item
// and gives one. A stage that turns out not to do so becomes the head. Bookkeeping of the simulator, no hardware.

#include <functional>
#include <vector>

#include "channels/dated_stage.h"

namespace bump {

class DatedChain {
 public:
  /// Stages and their graph, in order; finds the chain at its end by itself (it may be empty, and then nothing is ever passed).
  DatedChain(const TimingGraph& graph, std::vector<DatedStage*> stages);

  /// Passes what can be passed whole. `refill` is called when the input of the chain is empty and says whether anything came. True if any
  /// token moved.
  bool pass(const std::function<bool()>& refill);
  /// The stage whose input the chain takes; as many stages as there are when there is no chain.
  std::size_t first() const { return first_; }
  /// Whether a stage's state is here: it must not be dated elsewhere before settle().
  bool holds(std::size_t stage) const { return loaded_ && stage >= first_; }
  /// Last delivery of a stage that is held, -1 before the first or without any.
  Cycle latest() const;
  /// Hands the state back to the stages and FIFOs.
  void settle();
  /// Settles, and passes nothing any more.
  void retire();

 private:
  using Index = std::int64_t;  ///< of a token that goes through the whole chain, into the buffers

  /// A stage and the FIFO behind it. The buffers' names are those of timing_graph.h.
  struct Link {
    // The record of the next tokens: those from `read_at` on, without `until`.
    Cycle interval = 1, to_ready = 1;
    int misses = 0;
    Index read_at = 0, until = 0;
    // What the recurrence needs.
    Cycle free = 0;                ///< s(k-1) + ii(k-1)
    Cycle* starts = nullptr;       ///< s(k); not of the head, which starts more tokens than it passes on
    Cycle* deliveries = nullptr;   ///< w(k)
    const Cycle* room = nullptr;   ///< w(k - C)
    const Cycle* freed = nullptr;  ///< start of token k - D in the next stage; long ago behind the last
    DatedMemory* memory = nullptr;
    // What is counted.
    Cycle starved = 0, busy = 0, blocked_output = 0, first_free = 0;
    std::int64_t depth = 0, largest = 0;
    Cycle full = 0, empty = 0;  ///< of the FIFO behind it
  };
  /// What the head has besides: its tokens need not give an item.
  struct Head {
    Cycle start = -1, delivery = -1;
    DatedFifo* fed = nullptr;  ///< the FIFO in front of the chain, if any
  };
  struct Step {
    std::int64_t tokens = 0;  ///< alike in every stage; 0: none can pass now
    bool gives = false;       ///< they go on behind the head
  };

  bool can_load();
  void load();
  void load_link(std::size_t link);
  void settle_link(std::size_t link);
  /// Reads the record of a stage's next tokens. False if there is none yet, or none that may pass in a chain.
  bool read_record(std::size_t link);
  Step next_step(const std::function<bool()>& refill);
  /// Of the head: starts its next token and returns when that is done.
  Cycle begin_head(const TokenRecord& record);
  void end_head(Cycle delivery);
  void drop_at_head(std::int64_t tokens);
  void pass_on(std::int64_t tokens);
  /// Sums up what the dates since the last time tell.
  void count();
  /// Counts, and makes room in the buffers.
  void rewind();
  std::size_t own_way();
  bool head_could_go() const;

  std::vector<DatedStage*> stages_;
  std::size_t first_ = 0;
  bool loaded_ = false;
  std::vector<Link> links_;  ///< of the stages from first_ on
  Head head_;
  Index history_ = 0, room_ = 0;  ///< dates in front of and behind the first token of a buffer
  Index next_ = 0, counted_ = 0;  ///< first token that is not dated, not counted
  std::int64_t passed_ = 0;       ///< tokens since load()
  std::vector<std::vector<Cycle>> buffers_;
};

}  // namespace bump
