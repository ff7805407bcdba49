#pragma once
// The most recent dates of a sequence of events, by index, in a ring whose size is a power of two. Dates of events before the first lie so
// far back that they never bind, which stands for "absent terms have a negative index". Bookkeeping of the simulator, no hardware.

#include <cstdint>
#include <vector>

#include "channels/timing_graph.h"

namespace bump {

/// Far before cycle 0, and far enough from the end of the range to add latencies to.
constexpr Cycle long_ago = -(Cycle{1} << 60);

class DateRing {
 public:
  /// Holds at least the last `length` dates.
  explicit DateRing(std::int64_t length) {
    std::uint64_t size = 1;
    while (size < static_cast<std::uint64_t>(length)) size *= 2;
    dates_.assign(static_cast<std::size_t>(size), long_ago);
    mask_ = size - 1;
  }

  Cycle& operator[](std::int64_t index) { return dates_[static_cast<std::uint64_t>(index) & mask_]; }
  Cycle operator[](std::int64_t index) const { return dates_[static_cast<std::uint64_t>(index) & mask_]; }

  /// For inner loops that keep both in registers: element i is data()[uint64(i) & mask()].
  Cycle* data() { return dates_.data(); }
  std::uint64_t mask() const { return mask_; }

 private:
  std::vector<Cycle> dates_;
  std::uint64_t mask_ = 0;
};

}  // namespace bump
