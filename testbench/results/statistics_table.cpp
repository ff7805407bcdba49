#include "testbench/results/statistics_table.h"

#include <fmt/core.h>

#include <cmath>

namespace bump {

namespace {

class Rows {
 public:
  void module(const std::string& name) { module_ = name; }
  void add(const std::string& statistic, std::int64_t value, const std::string& unit) {
    rows_.push_back({module_, statistic, fmt::format("{}", value), unit});
  }
  void add(const std::string& statistic, int value, const std::string& unit) { add(statistic, std::int64_t{value}, unit); }
  void add(const std::string& statistic, double value, const std::string& unit) {
    rows_.push_back({module_, statistic, std::isnan(value) ? "" : fmt::format("{}", value), unit});
  }
  void add(const std::string& statistic, const std::optional<double>& value, const std::string& unit) {
    rows_.push_back({module_, statistic, value ? fmt::format("{}", *value) : "", unit});
  }
  std::vector<StatisticRow> take() { return std::move(rows_); }

 private:
  std::string module_;
  std::vector<StatisticRow> rows_;
};

void add_timing(Rows& rows, const TimingResult& timing) {
  for (const StageStatistics& stage : timing.stages) {
    rows.module(stage.name);
    rows.add("tokens", stage.tokens, "tokens");
    rows.add("busy", stage.busy, "cycles");
    rows.add("starved", stage.starved, "cycles");
    rows.add("blocked_room", stage.blocked_room, "cycles");
    rows.add("blocked_output", stage.blocked_output, "cycles");
    rows.add("last_delivery", stage.last_delivery < 0 ? std::nullopt : std::optional<double>(static_cast<double>(stage.last_delivery)),
             "cycles");
  }
  for (const FifoStatistics& fifo : timing.fifos) {
    rows.module(fifo.name);
    rows.add("depth", fifo.depth, "tokens");
    rows.add("items", fifo.items, "tokens");
    rows.add("max_occupancy", fifo.max_occupancy, "tokens");
    rows.add("full_cycles", fifo.full_cycles, "cycles");
    rows.add("empty_cycles", fifo.empty_cycles, "cycles");
  }
  for (const MemoryStatistics& memory : timing.memories) {
    rows.module(memory.name);
    rows.add("requests", memory.requests, "requests");
    rows.add("busy", memory.busy, "cycles");
  }
}

void add_unit(Rows& rows, const UnitCost& unit) {
  rows.module("operators." + unit.name);
  for (const auto& [prefix, inventory] : {std::pair{"built_", &unit.published}, std::pair{"additional_", &unit.addition}}) {
    const std::string start = prefix;
    rows.add(start + "multipliers", inventory->multipliers, "operators");
    rows.add(start + "adders", inventory->adders, "operators");
    rows.add(start + "dividers", inventory->dividers, "operators");
    rows.add(start + "square_roots", inventory->square_roots, "operators");
    rows.add(start + "tables", inventory->tables, "operators");
    rows.add(start + "maps", inventory->maps, "operators");
    rows.add(start + "shifters", inventory->shifters, "operators");
    rows.add(start + "table_bits", inventory->table_bits, "bits");
  }
  rows.add("executions", unit.executions, "executions");
  if (!unit.pipeline) return;
  rows.add("latency", unit.pipeline->latency, "cycles");
  rows.add("initiation_interval", unit.pipeline->initiation_interval, "cycles");
  rows.add("multipliers_after_sharing", unit.pipeline->multipliers, "operators");
}

void add_light_map(Rows& rows, const LightMapUse& map) {
  rows.module("light_map." + map.name);
  rows.add("entries", map.entries, "words");
  rows.add("bits", map.bits, "bits");
  rows.add("words_written", map.words_written, "words");
  rows.add("bytes_written", map.bytes_written, "bytes");
  rows.add("reads", map.counters.reads, "words");
  rows.add("hits", map.counters.hits, "words");
  rows.add("misses", map.counters.misses, "words");
  rows.add("hit_rate", hit_rate(map.counters), "1");
  rows.add("bytes", map.counters.bytes, "bytes");
  rows.add("clipped", map.counters.clipped, "words");
}

void add_quality(Rows& rows, const std::string& name, const std::optional<Quality>& quality) {
  if (!quality) return;
  rows.module("quality." + name);
  rows.add("psnr_db", std::isinf(quality->psnr_db) ? std::nan("") : quality->psnr_db, "dB");  // identical pictures have none
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string channel(1, "rgb"[c]);
    rows.add("nmse_" + channel, quality->nmse[c], "1");
    rows.add("rnmse_" + channel, quality->rnmse[c], "1");
    rows.add("pmse_" + channel, quality->pmse[c], "1");
    rows.add("rpmse_" + channel, quality->rpmse[c], "1");
  }
  rows.add("max_error", quality->max_error, "1/255");
  rows.add("mean_error", quality->mean_error, "1/255");
  rows.add("pixels", quality->pixels, "pixels");
  rows.add("excluded", quality->excluded, "pixels");
}

void add_angles(Rows& rows, const std::string& of, const std::vector<AngularError>& errors) {
  for (const AngularError& error : errors) {
    rows.module("angular_error." + of + "." + error.vector);
    rows.add("count", error.count, "vectors");
    rows.add("mean_degrees", error.mean_degrees, "degrees");
    rows.add("rms_degrees", error.rms_degrees, "degrees");
    rows.add("max_degrees", error.max_degrees, "degrees");
  }
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::vector<StatisticRow> statistic_rows(const RunReport& report) {
  const SimulationResult& result = *report.result;
  Rows rows;
  rows.module("run");
  rows.add("cycles", result.timing.cycles, "cycles");
  rows.add("fragments", result.fragments, "fragments");
  rows.add("fragments_per_cycle", fragments_per_cycle(result), "fragments/cycle");
  rows.add("bound_cycles", result.bound.cycles, "cycles");
  rows.add("clock", result.clock_megahertz, "MHz");
  rows.add("frames_per_second", frames_per_second(result), "frames/s");
  rows.add("interpolator_components", result.interpolator_components, "components");
  add_timing(rows, result.timing);
  for (const UnitCost& unit : result.units) add_unit(rows, unit);
  for (const TableUse& table : result.tables) {
    rows.module("table." + table.unit + "." + table.name);
    rows.add("entries", table.entries, "words");
    rows.add("bits", table.bits, "bits");
    rows.add("copies", table.copies, "copies");
    rows.add("reads", table.reads, "reads");
  }
  rows.module("texture");
  rows.add("reads", result.texture.reads, "texels");
  rows.add("accesses", result.texture.accesses, "lines");
  rows.add("hits", result.texture.hits, "lines");
  rows.add("misses", result.texture.misses, "lines");
  rows.add("hit_rate", hit_rate(result.texture), "1");
  rows.add("bytes", result.texture.bytes, "bytes");
  for (const LightMapUse& map : result.light_maps) add_light_map(rows, map);
  rows.module("geometry");
  const GeometryCounters& geometry = result.geometry;
  rows.add("vertices", geometry.vertices, "vertices");
  rows.add("vertex_reuses", geometry.vertex_reuses, "vertices");
  rows.add("triangles", geometry.triangles, "triangles");
  rows.add("triangles_clipped", geometry.triangles_clipped, "triangles");
  rows.add("triangles_culled", geometry.triangles_culled, "triangles");
  rows.add("triangles_empty", geometry.triangles_empty, "triangles");
  rows.add("triangles_hidden", geometry.triangles_hidden, "triangles");
  rows.add("triangles_drawn", geometry.triangles_drawn, "triangles");
  rows.add("fragments_generated", geometry.fragments_generated, "fragments");
  rows.add("fragments_hidden", geometry.fragments_hidden, "fragments");
  rows.add("fragments", geometry.fragments, "fragments");
  rows.add("fragments_retired", geometry.fragments_retired, "fragments");
  add_quality(rows, "against_reference", report.against_reference);
  add_quality(rows, "against_double", report.against_double);
  add_quality(rows, "against_blinn", report.against_blinn);
  add_quality(rows, "double_against_reference", report.double_against_reference);
  add_angles(rows, "hardware", result.angular_errors);
  add_angles(rows, "double", result.angular_errors_exact);
  return rows.take();
}

std::string to_csv(const std::vector<StatisticRow>& rows) {
  std::string text = "module,statistic,value,unit\n";
  for (const StatisticRow& row : rows) {
    text += quoted(row.module) + "," + quoted(row.statistic) + "," + quoted(row.value) + "," + quoted(row.unit) + "\n";
  }
  return text;
}

}  // namespace bump
