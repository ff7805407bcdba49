#include "retiming/trace_feeder.h"

#include <algorithm>

namespace bump {

namespace {

/// Tokens that are handed over at a time: enough to be quick, few enough to stop soon.
constexpr std::int64_t slice = 1 << 14;

}  // namespace

stage::Index stage_of(traced::Index stream) {
  constexpr std::array<stage::Index, traced::count> stages = {stage::vertex_processor, stage::triangle_setup, stage::rasterizer,
                                                              stage::texture_fetch, stage::light_map_fetch};
  return stages[stream];
}

TokenRecord record_under(const TokenRecord& record, traced::Index stream, const PipelineTiming& timing) {
  TokenRecord fitted = record;
  if (stream == traced::light_map) fitted.interval = std::max(fitted.interval, timing.interval[stage::light_map_fetch]);
  return fitted;
}

TraceFeeder::TraceFeeder(const TimingTrace& trace, const PipelineTiming& timing)
    : trace_(trace), timing_(timing), last_interval_(timing.graph.stages.size(), 0) {
  for (const TokenStream& stream : trace.streams) cursors_.emplace_back(stream);
}

double TraceFeeder::share() const {
  return static_cast<double>(done_) / static_cast<double>(std::max<std::int64_t>(1, trace_.streams[traced::raster].tokens));
}

void TraceFeeder::append_slice(TimingPlane& plane) {
  std::int64_t tokens = 0, triangles = 0, fragments = 0;
  TokenCursor& raster = cursors_[traced::raster];
  while (tokens < slice && !raster.at_end()) {
    const TokenRecord& record = raster.record();
    const std::uint32_t count = static_cast<std::uint32_t>(std::min<std::int64_t>(raster.left(), slice));
    if ((record.release & 1U) != 0) triangles += count;
    if ((record.give & 1U) != 0) fragments += count;
    append(plane, timing_.place[stage::rasterizer], record, count);
    raster.take(count);
    tokens += count;
  }
  done_ += tokens;
  if (raster.at_end() || triangles > 0) {
    append_stream(plane, traced::vertex, triangles);
    append_stream(plane, traced::setup, triangles);
  }
  append_stream(plane, traced::texture, fragments);
  if (timing_.place[stage::light_map_fetch] >= 0) append_stream(plane, traced::light_map, fragments);
  for (const int kind : {stage::interpolators, stage::environment, stage::illumination, stage::frame_sink}) {
    TokenRecord record;
    record.interval = timing_.interval[static_cast<std::size_t>(kind)];
    append(plane, timing_.place[static_cast<std::size_t>(kind)], record, fragments);
  }
}

void TraceFeeder::append_stream(TimingPlane& plane, traced::Index stream, std::int64_t count) {
  TokenCursor& cursor = cursors_[stream];
  while (count > 0) {
    const auto step = static_cast<std::uint32_t>(std::min<std::int64_t>(cursor.left(), count));
    append(plane, timing_.place[stage_of(stream)], record_under(cursor.record(), stream, timing_), step);
    cursor.take(step);
    count -= step;
  }
}

void TraceFeeder::append(TimingPlane& plane, int place, const TokenRecord& record, std::int64_t count) {
  if (count == 0) return;
  plane.append_uniform(place, record, static_cast<std::size_t>(count));
  last_interval_[static_cast<std::size_t>(place)] = record.interval;
}

}  // namespace bump
