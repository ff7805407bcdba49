#pragma once
// The vector kernel of re-timing: dates eight configurations at once over one trace, one SIMD lane each, by the recurrences of
// timing_graph.h: all stages of a triangle, then all stages of its first fragment, and so on. Depths and capacities that differ between
// lanes are looked up at different distances in a common history. Dates are 32 bits wide; whoever would need more is told so. Sums up
// what a row of a sweep reports, and no cycles of FIFOs. Bookkeeping of the simulator, no hardware.

#include <atomic>
#include <cstddef>
#include <vector>

#include "retiming/replay.h"
#include "retiming/token_program.h"

namespace bump {

class LaneDates {
 public:
  static constexpr std::size_t width = 8;  ///< configurations at once

  /// Whether the kernel dates this configuration: no batches, histories of moderate length, the stages of pipeline_timing.h.
  static bool serves(const PipelineTiming& timing);

  /// The program must outlive this. `timings`: 1 to `width` configurations of one design that are served.
  LaneDates(const TokenProgram& program, const std::vector<const PipelineTiming*>& timings);
  ~LaneDates();

  /// Dates all tokens. False if dates outgrow their width: then there is no result. `cancelled` (may be null) is polled; when it is set,
  /// the answer is false as well.
  bool run(const std::atomic<bool>* cancelled);

  /// Of configuration `lane`: everything but how FIFOs were filled.
  Retimed result(std::size_t lane) const;

 private:
  struct State;
  const TokenProgram& program_;
  std::vector<const PipelineTiming*> timings_;
  std::unique_ptr<State> state_;
};

}  // namespace bump
