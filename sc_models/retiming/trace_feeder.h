#pragma once
// Hands the records of a trace to a timing plane, slice by slice, as the units would: whichever plane dates them sees the tokens of a run.
// No hardware.

#include <cstdint>
#include <vector>

#include "channels/timing_plane.h"
#include "retiming/timing_trace.h"
#include "system/pipeline_timing.h"

namespace bump {

/// Kind of the stage that a stream belongs to.
stage::Index stage_of(traced::Index stream);

/// The record that a stage's token has under a configuration: light-map fetch takes at least as long as its address.
TokenRecord record_under(const TokenRecord& record, traced::Index stream, const PipelineTiming& timing);

/// Trace and timing must outlive it.
class TraceFeeder {
 public:
  TraceFeeder(const TimingTrace& trace, const PipelineTiming& timing);

  bool at_end() const { return cursors_[traced::raster].at_end(); }
  /// Appends some thousand tokens of the rasterizer and what belongs to them in the other stages; not at the end.
  void append_slice(TimingPlane& plane);
  /// Share of the rasterizer's tokens that were handed out, 0 to 1.
  double share() const;
  /// By stage of the graph: initiation interval of the last token so far.
  const std::vector<Cycle>& last_interval() const { return last_interval_; }

 private:
  void append_stream(TimingPlane& plane, traced::Index stream, std::int64_t count);
  void append(TimingPlane& plane, int place, const TokenRecord& record, std::int64_t count);

  const TimingTrace& trace_;
  const PipelineTiming& timing_;
  std::vector<TokenCursor> cursors_;
  std::vector<Cycle> last_interval_;
  std::int64_t done_ = 0;  ///< tokens of the rasterizer
};

}  // namespace bump
