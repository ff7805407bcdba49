#include "channels/fifo_sums.h"

#include <algorithm>

#include "datapath/lane_clones.h"

namespace bump {

namespace {

/// Sum of max(0, a[n] - b[n]).
BUMP_LANE_LOOP Cycle sum_of_gaps(const Cycle* a, const Cycle* b, std::int64_t count) {
  Cycle sum = 0;
  for (std::int64_t n = 0; n < count; ++n) sum += a[n] > b[n] ? a[n] - b[n] : 0;
  return sum;
}

/// How often a[n] < b[n].
BUMP_LANE_LOOP std::int64_t count_earlier(const Cycle* a, const Cycle* b, std::int64_t count) {
  std::int64_t earlier = 0;
  for (std::int64_t n = 0; n < count; ++n) earlier += a[n] < b[n] ? 1 : 0;
  return earlier;
}

}  // namespace

FifoSums fifo_sums(const Cycle* writes, const Cycle* removals, std::int64_t count, std::int64_t depth, std::int64_t largest) {
  FifoSums sums;
  sums.empty = sum_of_gaps(writes, removals - 1, count);
  sums.full = sum_of_gaps(removals - depth, writes - 1, count);
  while (largest < depth && count_earlier(writes - depth + largest, removals - depth, count) > 0) ++largest;
  sums.largest = largest;
  return sums;
}

}  // namespace bump
