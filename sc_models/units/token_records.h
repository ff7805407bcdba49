#pragma once
// The timing records that a unit leaves in a block, as runs of equal records: most tokens of a block are alike, so that a block of 256
// fragments usually takes a handful of runs instead of 256 records. It reads like a sequence of records, one per token. Bookkeeping of the
// simulator, no hardware and no time.

#include <cstddef>
#include <iterator>
#include <vector>

#include "channels/token_runs.h"
#include "datapath/invariant.h"

namespace bump {

class TokenRecords {
 public:
  /// `count` >= 0 tokens with the same record.
  void append(const TokenRecord& record, std::int64_t count) {
    if (count == 0) return;
    tokens_ += static_cast<std::size_t>(count);
    if (!runs_.empty() && same_record(runs_.back().record, record))
      runs_.back().count += count;
    else
      runs_.push_back({record, count});
  }
  void push_back(const TokenRecord& record) { append(record, 1); }
  void append(const TokenRecords& others) {
    for (const TokenRun& run : others.runs_) append(run.record, run.count);
  }
  /// Puts `record` in the place of the last one; not empty.
  void replace_back(const TokenRecord& record) {
    BUMP_ASSERT(tokens_ > 0);
    if (--runs_.back().count == 0) runs_.pop_back();
    --tokens_;
    push_back(record);
  }
  void clear() {
    runs_.clear();
    tokens_ = 0;
  }

  /// Tokens.
  std::size_t size() const { return tokens_; }
  bool empty() const { return tokens_ == 0; }
  const TokenRecord& back() const { return runs_.back().record; }
  /// Neighbouring runs differ.
  const std::vector<TokenRun>& runs() const { return runs_; }

  /// Token by token.
  class const_iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = TokenRecord;
    using difference_type = std::ptrdiff_t;
    using pointer = const TokenRecord*;
    using reference = const TokenRecord&;

    const_iterator(const TokenRun* run, std::int64_t used) : run_(run), used_(used) {}
    reference operator*() const { return run_->record; }
    pointer operator->() const { return &run_->record; }
    const_iterator& operator++() {
      if (++used_ == run_->count) {
        ++run_;
        used_ = 0;
      }
      return *this;
    }
    const_iterator operator++(int) {
      const_iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const const_iterator& o) const { return run_ == o.run_ && used_ == o.used_; }
    bool operator!=(const const_iterator& o) const { return !(*this == o); }

   private:
    const TokenRun* run_;
    std::int64_t used_;
  };
  const_iterator begin() const { return {runs_.data(), 0}; }
  const_iterator end() const { return {runs_.data() + runs_.size(), 0}; }

  /// All records, one per token, for readers that want them so.
  operator std::vector<TokenRecord>() const { return {begin(), end()}; }

  /// The record of a token, found run by run.
  const TokenRecord& operator[](std::size_t token) const {
    BUMP_ASSERT(token < tokens_);
    const TokenRun* run = runs_.data();
    for (; token >= static_cast<std::size_t>(run->count); ++run) token -= static_cast<std::size_t>(run->count);
    return run->record;
  }

 private:
  std::vector<TokenRun> runs_;
  std::size_t tokens_ = 0;
};

}  // namespace bump
