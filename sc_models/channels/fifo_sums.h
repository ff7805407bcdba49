#pragma once
// What a FIFO of a chain has counted over a stretch of items, from the dates of their writes and removals; the sums are those of
// DatedFifo. Bookkeeping of the simulator, no hardware.

#include "channels/timing_graph.h"

namespace bump {

struct FifoSums {
  Cycle full = 0, empty = 0;
  std::int64_t largest = 0;
};

/// Items 0 to count-1 of a FIFO that held `largest` items at most before. Item n was written at writes[n] and removed at removals[n]; both
/// reach back to n = -depth and -1.
FifoSums fifo_sums(const Cycle* writes, const Cycle* removals, std::int64_t count, std::int64_t depth, std::int64_t largest);

}  // namespace bump
