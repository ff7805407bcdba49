#include "retiming/replay.h"

#include <algorithm>

#include "channels/timeline.h"

namespace bump {

namespace {

/// Fragments that are handed to the timeline at a time: enough to be quick, few enough to stop soon.
constexpr std::int64_t slice = 1 << 14;

class Replay {
 public:
  Replay(const TimingTrace& trace, const PipelineTiming& timing) : trace_(trace), timing_(timing), timeline_(timing.graph) {
    for (const TokenStream& stream : trace.streams) cursors_.emplace_back(stream);
    result_.last_interval.assign(timing.graph.stages.size(), 0);
  }

  Retimed run(const std::function<void(double)>& watch) {
    std::int64_t done = 0;
    while (!cursors_[traced::raster].at_end()) {
      done += append_slice();
      timeline_.advance();
      if (watch) watch(static_cast<double>(done) / static_cast<double>(std::max<std::int64_t>(1, trace_.streams[traced::raster].tokens)));
    }
    result_.timing = timeline_.finish();
    return std::move(result_);
  }

 private:
  /// The next tokens of the rasterizer and what belongs to them in the other stages. Returns how many.
  std::int64_t append_slice() {
    std::int64_t tokens = 0, triangles = 0, fragments = 0;
    TokenCursor& raster = cursors_[traced::raster];
    while (tokens < slice && !raster.at_end()) {
      const TokenRecord& record = raster.record();
      const std::uint32_t count = static_cast<std::uint32_t>(std::min<std::int64_t>(raster.left(), slice));
      if ((record.release & 1U) != 0) triangles += count;
      if ((record.give & 1U) != 0) fragments += count;
      append(timing_.place[stage::rasterizer], record, count);
      raster.take(count);
      tokens += count;
    }
    if (raster.at_end() || triangles > 0) {
      append_stream(traced::vertex, triangles);
      append_stream(traced::setup, triangles);
    }
    append_stream(traced::texture, fragments);
    if (timing_.place[stage::light_map_fetch] >= 0) append_stream(traced::light_map, fragments);
    for (const int kind : {stage::interpolators, stage::environment, stage::illumination, stage::frame_sink}) {
      TokenRecord record;
      record.interval = timing_.interval[static_cast<std::size_t>(kind)];
      append(timing_.place[static_cast<std::size_t>(kind)], record, fragments);
    }
    return tokens;
  }

  void append_stream(traced::Index stream, std::int64_t count) {
    TokenCursor& cursor = cursors_[stream];
    while (count > 0) {
      const auto step = static_cast<std::uint32_t>(std::min<std::int64_t>(cursor.left(), count));
      append(timing_.place[stage_of(stream)], record_under(cursor.record(), stream, timing_), step);
      cursor.take(step);
      count -= step;
    }
  }

  void append(int place, const TokenRecord& record, std::int64_t count) {
    if (count == 0) return;
    timeline_.append_uniform(place, record, static_cast<std::size_t>(count));
    result_.last_interval[static_cast<std::size_t>(place)] = record.interval;
  }

  const TimingTrace& trace_;
  const PipelineTiming& timing_;
  Timeline timeline_;
  std::vector<TokenCursor> cursors_;
  Retimed result_;
};

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

Retimed replay(const TimingTrace& trace, const PipelineTiming& timing, const std::function<void(double)>& watch) {
  return Replay(trace, timing).run(watch);
}

}  // namespace bump
