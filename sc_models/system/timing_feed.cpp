#include "system/timing_feed.h"

namespace bump {

namespace {

void append_all(TimingPlane& plane, int index, const std::vector<TokenRecord>& records, std::vector<Cycle>& last_interval) {
  if (records.empty()) return;
  plane.append(index, records.data(), records.size());
  last_interval[static_cast<std::size_t>(index)] = records.back().interval;
}

}  // namespace

std::unique_ptr<TimingRecords> records_of(const FragmentBlock& block) {
  auto records = std::make_unique<TimingRecords>();
  records->vertex = block.vertex_records;
  records->setup = block.setup_records;
  records->raster = block.raster_records;
  records->texture = block.texture_records;
  records->fragments = block.lanes;
  return records;
}

void feed(TimingPlane& plane, const TimingRecords& records, const PipelineTiming& timing, std::vector<Cycle>& last_interval) {
  append_all(plane, stage::vertex_processor, records.vertex, last_interval);
  append_all(plane, stage::triangle_setup, records.setup, last_interval);
  append_all(plane, stage::rasterizer, records.raster, last_interval);
  append_all(plane, stage::texture_fetch, records.texture, last_interval);
  if (records.fragments == 0) return;
  for (const int index : {stage::interpolators, stage::environment, stage::illumination, stage::frame_sink}) {
    TokenRecord record;
    record.interval = timing.interval[static_cast<std::size_t>(index)];
    plane.append_uniform(index, record, static_cast<std::size_t>(records.fragments));
    last_interval[static_cast<std::size_t>(index)] = record.interval;
  }
}

}  // namespace bump
