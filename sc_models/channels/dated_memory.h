#pragma once
// A memory port behind one stage, as dates: requests are granted in token order, one line at a time on the bus, with a bounded number of
// misses in flight (a miss holds its slot up to and including the cycle of its fill). Leaves out banks, rows and refresh: latency is
// constant.

#include <algorithm>
#include <vector>

#include "channels/date_ring.h"

namespace bump {

class DatedMemory {
 public:
  explicit DatedMemory(const MemorySpec& spec) : spec_(spec), fills_(static_cast<std::size_t>(spec.outstanding), long_ago) {}

  /// Asks for `lines` > 0 lines for a token that starts at `start`; returns the fill of the last of them.
  Cycle request(Cycle start, int lines) {
    Cycle fill = 0;
    for (int i = 0; i < lines; ++i) {
      Cycle& oldest = fills_[next_];
      const Cycle grant = std::max({start + spec_.tag_latency, bus_free_, oldest + 1});
      bus_free_ = grant + spec_.cycles_per_line;
      oldest = fill = grant + spec_.latency;
      if (++next_ == fills_.size()) next_ = 0;
    }
    requests_ += lines;
    return fill;
  }

  MemoryStatistics statistics() const { return {spec_.name, requests_, requests_ * spec_.cycles_per_line}; }

 private:
  MemorySpec spec_;
  std::vector<Cycle> fills_;  ///< of the last M misses; next_ is the oldest
  std::size_t next_ = 0;
  Cycle bus_free_ = 0;
  std::int64_t requests_ = 0;
};

}  // namespace bump
