#include "retiming/token_program.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr std::uint32_t most = 1U << 24;

TokenStep::Work work_of(const TokenRecord& record) {
  return {static_cast<std::int32_t>(record.interval), static_cast<std::int32_t>(record.lead)};
}

bool fits(const TimingTrace& trace) {
  for (const TokenStream& stream : trace.streams)
    for (const TokenRecord& record : stream.kinds)
      if (record.interval >= most || record.lead >= most) return false;
  return true;
}

void count_totals(const TimingTrace& trace, TokenProgram& program) {
  program.triangles = trace.triangles();
  program.fragments = trace.fragments();
  program.raster_tokens = trace.streams[traced::raster].tokens;
  for (std::size_t i = 0; i < traced::count; ++i) {
    const TokenStream& stream = trace.streams[i];
    std::int64_t work = 0;
    for (const TokenRecord& record : stream.kinds) {
      work = std::max<std::int64_t>(work, std::int64_t{record.interval} + record.lead);
      program.most_misses = std::max<std::int64_t>(program.most_misses, record.misses);
    }
    program.most_work += work;
    std::int64_t misses = 0;
    for (const TokenStream::Run& run : stream.runs) {
      program.busy[i] += std::int64_t{run.count} * stream.record(run).interval;
      misses += std::int64_t{run.count} * stream.record(run).misses;
    }
    if (i == traced::texture) program.requests = misses;
    if (i == traced::light_map) program.light_requests = misses;
    if (!stream.runs.empty()) program.last_interval[i] = stream.record(stream.runs.back()).interval;
  }
}

class Merger {
 public:
  Merger(const TimingTrace& trace, std::vector<TokenStep>& steps)
      : steps_(steps),
        vertex_(trace.streams[traced::vertex]),
        setup_(trace.streams[traced::setup]),
        raster_(trace.streams[traced::raster]),
        texture_(trace.streams[traced::texture]),
        light_map_(trace.streams[traced::light_map]),
        has_maps_(trace.streams[traced::light_map].tokens > 0) {}

  void run() {
    for (bool between = true; !raster_.at_end();) {
      if (between) triangle();
      between = raster_token();
    }
  }

 private:
  void triangle() {
    TokenStep step;
    step.kind = TokenStep::Kind::triangle;
    step.first = work_of(vertex_.record());
    step.second = work_of(setup_.record());
    vertex_.take(1);
    setup_.take(1);
    steps_.push_back(step);
  }

  /// As many as are alike. True if the triangle ends with them.
  bool raster_token() {
    const TokenRecord& record = raster_.record();
    TokenStep step;
    step.first = work_of(record);
    step.releases = (record.release & 1U) != 0;
    step.count = step.releases ? 1 : raster_.left();
    if ((record.give & 1U) != 0) {
      step.count = std::min(step.count, texture_.left());
      step.second = work_of(texture_.record());
      step.misses = texture_.record().misses;
      if (has_maps_) {
        step.count = std::min(step.count, light_map_.left());
        step.third = work_of(light_map_.record());
        step.light_misses = light_map_.record().misses;
        light_map_.take(step.count);
      }
      texture_.take(step.count);
    } else {
      step.kind = TokenStep::Kind::dropped;
    }
    raster_.take(step.count);
    steps_.push_back(step);
    return step.releases;
  }

  std::vector<TokenStep>& steps_;
  TokenCursor vertex_, setup_, raster_, texture_, light_map_;
  bool has_maps_;
};

}  // namespace

TokenProgram make_token_program(const TimingTrace& trace) {
  TokenProgram program;
  count_totals(trace, program);
  if (fits(trace)) {
    Merger(trace, program.steps).run();
    program.complete = true;
  }
  return program;
}

}  // namespace bump
