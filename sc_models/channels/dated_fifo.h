#pragma once
// A bounded FIFO with registered full and empty flags, as dates: when each of its last items was written (w) and removed (r). An item
// written in cycle w and removed in cycle r takes a slot in cycles w+1 to r; item n can be written in r(n-D)+1 at the earliest. Statistics
// are summed from the same dates, each as soon as it is known:
//   full   : sum over n of max(0, r(n-D+1) - w(n)); known when item n+1 is written, because that needs r(n+1-D)
//   empty  : sum over n of max(0, w(n) - r(n-1)); known when item n is removed
//   largest: the greatest q with w(m+q-1) < r(m) for some m; looked at for m = n-D when item n is written

#include <algorithm>

#include "channels/date_ring.h"

namespace bump {

class DatedFifo {
 public:
  explicit DatedFifo(const FifoSpec& spec)
      : from(spec.from), to(spec.to), depth(spec.depth), writes(spec.depth), removals(spec.depth), name_(spec.name) {}

  std::int64_t held() const { return written - removed; }
  std::int64_t room() const { return depth - held(); }

  /// Sums up what item `written` tells before it is written; `freed` is the removal of the item that had its slot, r(written - D).
  void account_write(Cycle freed) {
    full_ += std::max<Cycle>(0, freed - last_write);
    while (largest_ < depth && writes[written - depth + largest_] < freed) ++largest_;
  }
  void write(Cycle date) {
    writes[written++] = date;
    last_write = date;
  }
  void remove(Cycle date) {
    empty_ += std::max<Cycle>(0, writes[removed] - last_removal);
    removals[removed++] = date;
    last_removal = date;
  }
  /// For inner loops that write or remove several items and keep the state in registers meanwhile.
  void add_full(Cycle cycles) { full_ += cycles; }
  void add_empty(Cycle cycles) { empty_ += cycles; }
  std::int64_t largest() const { return largest_; }
  void set_largest(std::int64_t items) { largest_ = items; }

  /// After the last item was removed: totals over cycles [0, cycles).
  FifoStatistics statistics(Cycle cycles) const {
    FifoStatistics result{name_, depth, written, largest_, full_, empty_ + cycles - 1 - last_removal};
    if (written == 0) {
      result.empty_cycles = cycles;
      return result;
    }
    result.full_cycles += std::max<Cycle>(0, removals[written - depth] - last_write);
    for (std::int64_t m = std::max<std::int64_t>(0, written - depth); m < written; ++m)
      while (m + result.max_occupancy < written && writes[m + result.max_occupancy] < removals[m]) ++result.max_occupancy;
    return result;
  }

  const int from, to;
  const std::int64_t depth;
  DateRing writes, removals;
  std::int64_t written = 0, removed = 0;
  Cycle last_write = -1, last_removal = -1;
  std::int64_t total = -1;  ///< items that will ever be written; -1 while unknown

 private:
  std::string name_;
  std::int64_t largest_ = 0;
  Cycle full_ = 0, empty_ = 0;
};

}  // namespace bump
