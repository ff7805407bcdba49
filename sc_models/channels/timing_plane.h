#pragma once
// The timing plane of a simulation: it takes the token records that the units leave behind, stage by stage in token order, and turns them into
// dates. Two implementations with identical results: Timeline (dated recurrences, timeline.h) and the clocked engine (stepped_engine.h).

#include <cstddef>

#include "channels/timing_graph.h"

namespace bump {

class TimingPlane {
 public:
  virtual ~TimingPlane() = default;
  /// Appends the records of the next `count` tokens of a stage. Order between stages does not matter.
  virtual void append(int stage, const TokenRecord* records, std::size_t count) = 0;
  /// Appends `count` equal records.
  virtual void append_uniform(int stage, const TokenRecord& record, std::size_t count) = 0;
};

}  // namespace bump
