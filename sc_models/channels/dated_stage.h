#pragma once
// One stage of the timeline: dates the starts and the deliveries of its tokens by the recurrences of timing_graph.h, in chunks of tokens
// with equal records for which every date that is needed is known. Starts and deliveries have cursors of their own, because a token that
// has started frees its input slot even while it cannot be delivered; as long as nothing depends on that, ordinary tokens pass in one go,
// which is quicker.

#include <vector>

#include "channels/dated_fifo.h"
#include "channels/dated_memory.h"
#include "channels/token_runs.h"

namespace bump {

class DatedStage {
 public:
  DatedStage(const StageSpec& spec, std::vector<DatedFifo*> inputs, std::vector<DatedFifo*> outputs, DatedMemory* memory);

  void append(const TokenRecord& record, std::int64_t count);

  struct Progress {
    bool started = false, delivered = false;
  };
  /// Dates what can be dated now. Unless `eager`, starts of ordinary tokens that cannot be delivered yet may be left for later.
  Progress date(bool eager);
  /// Frees the records of delivered tokens.
  void drop_delivered() { runs_.drop_before(deliver_); }

  std::int64_t started() const { return started_; }
  std::int64_t delivered() const { return delivered_; }
  std::vector<TokenRun> undelivered() const { return runs_.rest(deliver_); }
  /// Of a stage with one input: whether an item waits in it.
  bool has_input() const { return inputs_[0]->held() > 0; }
  Cycle last_start() const { return last_start_; }
  Cycle last_delivery() const { return last_delivery_; }
  StageStatistics statistics() const;

 private:
  friend class DatedChain;  // date several stages at once, on the same state

  struct Chunk {
    std::int64_t count = 0;
    Cycle gathered = long_ago;  ///< first cycle in which the batch of its first token can be seen
  };
  Chunk startable();
  std::int64_t deliverable();
  bool start_some();
  bool deliver_some();
  /// The next token is ordinary: it takes one item of every input, gives one to every output, misses nothing; at most one of each.
  bool next_is_ordinary();
  std::int64_t passable();
  template <bool HasInput, bool HasOutput>
  void pass(std::int64_t count);
  void pass_some(std::int64_t count);

  StageSpec spec_;
  std::vector<DatedFifo*> inputs_, outputs_;
  DatedMemory* memory_;
  const bool simple_;  ///< at most one input and output, no batch
  TokenRuns runs_;
  TokenRuns::Cursor start_, deliver_;
  std::int64_t started_ = 0, delivered_ = 0;
  DateRing ready_;                       ///< max(s + lead + L, fill + 1) of the tokens in flight
  DateRing deliveries_;                  ///< w of the last C tokens
  Cycle free_ = 0;                       ///< s(k-1) + ii(k-1)
  Cycle last_start_ = -1, last_delivery_ = -1;
  StageStatistics sums_;
};

}  // namespace bump
