#include "system/timing_feed.h"

#include <algorithm>

namespace bump {

namespace {

void append_all(TimingPlane& plane, int index, const TokenRecords& records, std::vector<Cycle>& last_interval) {
  if (records.empty()) return;
  for (const TokenRun& run : records.runs()) plane.append_uniform(index, run.record, static_cast<std::size_t>(run.count));
  last_interval[static_cast<std::size_t>(index)] = records.back().interval;
}

}  // namespace

std::unique_ptr<TimingRecords> records_of(const FragmentBlock& block) {
  auto records = std::make_unique<TimingRecords>();
  records->vertex = block.vertex_records;
  records->setup = block.setup_records;
  records->raster = block.raster_records;
  records->texture = block.texture_records;
  records->light_map = block.light_map_records;
  records->fragments = block.lanes;
  return records;
}

void feed(TimingPlane& plane, const TimingRecords& records, const PipelineTiming& timing, std::vector<Cycle>& last_interval) {
  append_all(plane, timing.place[stage::vertex_processor], records.vertex, last_interval);
  append_all(plane, timing.place[stage::triangle_setup], records.setup, last_interval);
  append_all(plane, timing.place[stage::rasterizer], records.raster, last_interval);
  append_all(plane, timing.place[stage::texture_fetch], records.texture, last_interval);
  if (!records.light_map.empty()) {
    TokenRecords fetched;
    for (const TokenRun& run : records.light_map.runs()) {
      TokenRecord record = run.record;
      record.interval = std::max(record.interval, timing.interval[stage::light_map_fetch]);
      fetched.append(record, run.count);
    }
    append_all(plane, timing.place[stage::light_map_fetch], fetched, last_interval);
  }
  if (records.fragments == 0) return;
  for (const int kind : {stage::interpolators, stage::environment, stage::illumination, stage::frame_sink}) {
    const int index = timing.place[static_cast<std::size_t>(kind)];
    TokenRecord record;
    record.interval = timing.interval[static_cast<std::size_t>(kind)];
    plane.append_uniform(index, record, static_cast<std::size_t>(records.fragments));
    last_interval[static_cast<std::size_t>(index)] = record.interval;
  }
}

}  // namespace bump
