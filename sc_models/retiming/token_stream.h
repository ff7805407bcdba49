#pragma once
// The records of one stage, for keeping: runs of equal records over a list of the distinct ones. Most tokens of a stage are alike, and
// those that are not come in few kinds, so that a run costs one or two bytes in a file (trace_file.h). Bookkeeping of the simulator, no
// hardware.

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "channels/timing_graph.h"
#include "units/token_records.h"

namespace bump {

struct TokenStream {
  struct Run {
    std::uint32_t kind = 0;   ///< index into `kinds`
    std::uint32_t count = 0;  ///< tokens, >= 1
  };
  std::vector<TokenRecord> kinds;  ///< distinct, in the order in which they appeared
  std::vector<Run> runs;
  std::int64_t tokens = 0;  ///< sum of the counts

  const TokenRecord& record(const Run& run) const { return kinds[run.kind]; }
};

/// Walks over the runs of a stream in pieces of any size.
class TokenCursor {
 public:
  explicit TokenCursor(const TokenStream& stream) : stream_(&stream) {}

  bool at_end() const { return run_ == stream_->runs.size(); }
  /// Record of the next token, and how many like it follow at once; not at the end.
  const TokenRecord& record() const { return stream_->record(stream_->runs[run_]); }
  std::uint32_t left() const { return stream_->runs[run_].count - used_; }
  /// 1 <= count <= left().
  void take(std::uint32_t count) {
    used_ += count;
    if (used_ < stream_->runs[run_].count) return;
    used_ = 0;
    ++run_;
  }

 private:
  const TokenStream* stream_;
  std::size_t run_ = 0;
  std::uint32_t used_ = 0;
};

/// Makes a stream of records as they come.
class TokenStreamBuilder {
 public:
  void append(const TokenRecord& record, std::uint32_t count = 1);
  void append(const TokenRecords& records) {
    for (const TokenRun& run : records.runs()) append(run.record, static_cast<std::uint32_t>(run.count));
  }
  const TokenStream& stream() const { return stream_; }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint16_t, std::uint8_t, std::uint8_t, std::uint8_t>;
  std::uint32_t kind_of(const TokenRecord& record);

  TokenStream stream_;
  std::map<Key, std::uint32_t> kinds_;
};

}  // namespace bump
