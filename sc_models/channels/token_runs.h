#pragma once
// The records of a stage that are not used up yet, as runs of equal records: most tokens of a stage are alike, so a block of 256 fragments
// is usually one run. A cursor walks over the tokens; runs behind the slowest cursor are freed by the owner. Bookkeeping of the simulator,
// no hardware.

#include <cstdint>
#include <vector>

#include "channels/timing_graph.h"
#include "datapath/invariant.h"

namespace bump {

/// The record with its masks cut to the ports that the stage has. A record that contradicts the graph is a fault of the program.
inline TokenRecord fitted_record(TokenRecord record, std::size_t inputs, std::size_t outputs, bool has_memory) {
  record.take = static_cast<std::uint8_t>(record.take & ((1U << inputs) - 1U));
  record.release = static_cast<std::uint8_t>(record.release & ((1U << inputs) - 1U));
  record.give = static_cast<std::uint8_t>(record.give & ((1U << outputs) - 1U));
  BUMP_ASSERT(record.interval >= 1);
  BUMP_ASSERT((record.release & ~record.take) == 0);
  BUMP_ASSERT(record.misses == 0 || has_memory);
  return record;
}

inline bool same_record(const TokenRecord& a, const TokenRecord& b) {
  return a.interval == b.interval && a.lead == b.lead && a.misses == b.misses && a.take == b.take && a.release == b.release &&
         a.give == b.give;
}

struct TokenRun {
  TokenRecord record;
  std::int64_t count = 0;
};

class TokenRuns {
 public:
  /// A position between tokens. Stays valid across append() and drop_before().
  struct Cursor {
    std::uint64_t run = 0;  ///< ordinal of the run since the beginning
    std::int64_t used = 0;  ///< tokens of it behind the cursor
  };

  void append(const TokenRecord& record, std::int64_t count) {
    if (count == 0) return;
    appended_ += count;
    if (!runs_.empty() && same_record(runs_.back().record, record)) {
      runs_.back().count += count;
    } else {
      runs_.push_back({record, count});
    }
  }

  /// Tokens since the beginning.
  std::int64_t appended() const { return appended_; }

  /// Tokens of the cursor's run in front of it; steps to the next run when one is used up. 0 at the end of all records.
  std::int64_t left(Cursor& cursor) const {
    if (cursor.run - dropped_ >= runs_.size()) return 0;
    const TokenRun* run = &at(cursor);
    if (cursor.used == run->count) {
      if (cursor.run - dropped_ + 1 == runs_.size()) return 0;  // rests here: the run may still grow
      cursor = {cursor.run + 1, 0};
      run = &at(cursor);
    }
    return run->count - cursor.used;
  }

  /// Record of the token in front of the cursor; left() > 0.
  const TokenRecord& record(const Cursor& cursor) const { return at(cursor).record; }

  /// Frees runs in front of the cursor's (now and then, so that the cost per run is constant).
  void drop_before(const Cursor& cursor) {
    const std::size_t behind = static_cast<std::size_t>(cursor.run - dropped_);
    if (behind < 64 || behind * 2 < runs_.size()) return;
    runs_.erase(runs_.begin(), runs_.begin() + static_cast<std::ptrdiff_t>(behind));
    dropped_ += behind;
  }

  /// All runs from the cursor on.
  std::vector<TokenRun> rest(Cursor cursor) const {
    std::vector<TokenRun> found;
    while (left(cursor) > 0) {
      found.push_back({record(cursor), left(cursor)});
      cursor.used = at(cursor).count;
    }
    return found;
  }

 private:
  const TokenRun& at(const Cursor& cursor) const { return runs_[static_cast<std::size_t>(cursor.run - dropped_)]; }

  std::vector<TokenRun> runs_;
  std::uint64_t dropped_ = 0;
  std::int64_t appended_ = 0;
};

}  // namespace bump
