#include "testbench/results/result_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "datapath/inventory.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities: what is not a number is null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json number(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json channels(const std::array<double, 3>& values) {
  return Json::array({number(values[0]), number(values[1]), number(values[2])});
}

Json operators(const Inventory& inventory) {
  return {{"multipliers", inventory.multipliers},   {"adders", inventory.adders}, {"dividers", inventory.dividers},
          {"square_roots", inventory.square_roots}, {"tables", inventory.tables}, {"maps", inventory.maps},
          {"shifters", inventory.shifters}};
}

Json built(const Inventory& inventory) {
  Json json = operators(inventory);
  json["shifts"] = inventory.shifts;
  json["sign_logic"] = inventory.sign_logic;
  json["clamps"] = inventory.clamps;
  json["selects"] = inventory.selects;
  json["index_encoders"] = inventory.index_encoders;
  json["second_ports"] = inventory.second_ports;
  json["table_bits"] = inventory.table_bits;
  json["distinct_table_bits"] = inventory.distinct_table_bits;
  return json;
}

/// Operations executed for each shaded fragment, additions included: operators times executions over fragments, the part of a vertex
/// program that depends on the light once for every light.
Json used_per_fragment(const UnitCost& unit, std::int64_t fragments) {
  if (fragments <= 0) return nullptr;
  Inventory all = unit.published;
  all += unit.addition;
  // A table is read through each of its ports.
  const auto executed = [](Inventory inventory) {
    inventory.tables += inventory.second_ports;
    return operators(inventory);
  };
  Json json = executed(all);
  const Json repeated = executed(unit.per_light);
  for (auto& [name, value] : json.items()) {
    const double once = value.get<double>() + repeated[name].get<double>() * (unit.lights - 1);
    value = once * static_cast<double>(unit.executions) / static_cast<double>(fragments);
  }
  return json;
}

Json unit_json(const UnitCost& unit, std::int64_t fragments) {
  return {{"built", built(unit.published)},
          {"additional", built(unit.addition)},
          {"used_per_fragment", used_per_fragment(unit, fragments)},
          {"executions", unit.executions},
          {"latency", unit.pipeline ? Json(unit.pipeline->latency) : Json()},
          {"initiation_interval", unit.pipeline ? Json(unit.pipeline->initiation_interval) : Json()},
          {"multipliers_after_sharing", unit.pipeline ? Json(unit.pipeline->multipliers) : Json()}};
}

Json light_maps_json(const std::vector<LightMapUse>& maps) {
  Json list = Json::array();
  for (const LightMapUse& map : maps) {
    list.push_back({{"name", map.name},
                    {"entries", map.entries},
                    {"bits", map.bits},
                    {"words_written", map.words_written},
                    {"bytes_written", map.bytes_written},
                    {"reads", map.counters.reads},
                    {"hits", map.counters.hits},
                    {"misses", map.counters.misses},
                    {"hit_rate", number(hit_rate(map.counters))},
                    {"bytes", map.counters.bytes},
                    {"clipped", map.counters.clipped}});
  }
  return list;
}

Json angular(const std::vector<AngularError>& errors) {
  Json list = Json::array();
  for (const AngularError& error : errors) {
    list.push_back({{"vector", error.vector},
                    {"count", error.count},
                    {"mean_degrees", number(error.mean_degrees)},
                    {"rms_degrees", number(error.rms_degrees)},
                    {"max_degrees", number(error.max_degrees)}});
  }
  return list;
}

Json configuration_json(const Configuration& configuration) {
  Json json = Json::object();
  for (const auto& [key, entry] : configuration.entries())
    json[key] = std::visit([](const auto& value) { return Json(value); }, entry.value);
  return json;
}

/// What the scheme states for its widths; null where nothing was compared with it, or where it excludes nothing (bright lights).
Json stated_floor(const RunReport& report) {
  const bool applies = report.against_double && report.against_double->pixels > 0 && report.against_double->max_error > 0;
  const double floor = report.result->quantisation_floor_db;
  return applies && floor > 0 ? number(floor) : Json(nullptr);
}

Json quality_json(const RunReport& report) {
  const auto optional = [](const std::optional<Quality>& quality) { return quality ? to_json(*quality) : Json(nullptr); };
  return {{"against_reference", optional(report.against_reference)},
          {"against_double", optional(report.against_double)},
          {"against_blinn", optional(report.against_blinn)},
          {"double_against_reference", optional(report.double_against_reference)},
          {"quantisation_floor_db", stated_floor(report)}};
}

}  // namespace

Json to_json(const Quality& quality) {
  Json json = {{"psnr_db", number(quality.psnr_db)},       {"nmse", channels(quality.nmse)},   {"rnmse", channels(quality.rnmse)},
               {"pmse", channels(quality.pmse)},           {"rpmse", channels(quality.rpmse)}, {"max_error", number(quality.max_error)},
               {"mean_error", number(quality.mean_error)}, {"pixels", quality.pixels},         {"excluded", quality.excluded}};
  if (quality.pixels == 0)
    json["note"] = "no pixel shows the same surface in both images";
  else if (std::isinf(quality.psnr_db))
    json["note"] = "identical images: the signal-to-noise ratio is infinite";
  return json;
}

Json to_json(const RunReport& report) {
  const Scene& scene = *report.scene;
  const SchemePage& page = report.scheme->page();
  const SimulationResult& result = *report.result;

  Json json;
  json["schema"] = result_schema;
  json["schema_version"] = result_schema_version;
  json["status"] = report.status;
  json["scene"] = {{"name", scene.name},
                   {"width", scene.width},
                   {"height", scene.height},
                   {"objects", scene.objects.size()},
                   {"lights", scene.lights.size()},
                   {"warnings", scene.warnings}};
  json["scheme"] = {{"id", page.id}, {"title", page.title}, {"source", page.source}, {"provenance", page.provenance}};
  json["engine"] = report.engine;
  json["cycles"] = result.timing.cycles;
  json["fragments"] = result.fragments;
  json["fragments_per_cycle"] = number(fragments_per_cycle(result));
  json["bound"] = {{"cycles", number(result.bound.cycles)}, {"by", result.bound.by}};
  json["clock_megahertz"] = number(result.clock_megahertz);
  json["frames_per_second"] = number(frames_per_second(result));

  json["operators"] = Json::object();
  for (const UnitCost& unit : result.units) json["operators"][unit.name] = unit_json(unit, result.fragments);
  json["interpolator_components"] = result.interpolator_components;
  json["tables"] = Json::array();
  for (const TableUse& table : result.tables) {
    json["tables"].push_back({{"unit", table.unit},
                              {"name", table.name},
                              {"formula", table.formula},
                              {"entries", table.entries},
                              {"bits", table.bits},
                              {"copies", table.copies},
                              {"reads", table.reads},
                              {"addition", table.addition}});
  }

  const TextureCounters& texture = result.texture;
  json["texture"] = {{"reads", texture.reads},   {"accesses", texture.accesses},          {"hits", texture.hits},
                     {"misses", texture.misses}, {"hit_rate", number(hit_rate(texture))}, {"bytes", texture.bytes}};
  if (!result.light_maps.empty()) json["light_maps"] = light_maps_json(result.light_maps);
  const GeometryCounters& geometry = result.geometry;
  json["geometry"] = {{"vertices", geometry.vertices},
                      {"vertex_reuses", geometry.vertex_reuses},
                      {"triangles", geometry.triangles},
                      {"triangles_clipped", geometry.triangles_clipped},
                      {"triangles_culled", geometry.triangles_culled},
                      {"triangles_empty", geometry.triangles_empty},
                      {"triangles_hidden", geometry.triangles_hidden},
                      {"triangles_drawn", geometry.triangles_drawn},
                      {"fragments_generated", geometry.fragments_generated},
                      {"fragments_hidden", geometry.fragments_hidden},
                      {"fragments", geometry.fragments},
                      {"fragments_retired", geometry.fragments_retired}};

  json["modules"] = Json::array();
  for (const StageStatistics& stage : result.timing.stages) {
    json["modules"].push_back({{"name", stage.name},
                               {"tokens", stage.tokens},
                               {"busy", stage.busy},
                               {"starved", stage.starved},
                               {"blocked", stage.blocked_room},
                               {"blocked_output", stage.blocked_output},
                               {"last_delivery", stage.last_delivery < 0 ? Json(nullptr) : Json(stage.last_delivery)}});
  }
  json["fifos"] = Json::array();
  for (const FifoStatistics& fifo : result.timing.fifos) {
    json["fifos"].push_back({{"name", fifo.name},
                             {"depth", fifo.depth},
                             {"items", fifo.items},
                             {"max_occupancy", fifo.max_occupancy},
                             {"full_cycles", fifo.full_cycles},
                             {"empty_cycles", fifo.empty_cycles}});
  }
  json["memory"] = Json::array();
  for (const MemoryStatistics& memory : result.timing.memories) {
    json["memory"].push_back({{"name", memory.name}, {"requests", memory.requests}, {"busy", memory.busy}});
  }

  json["quality"] = quality_json(report);
  json["angular_error"] = {{"hardware", angular(result.angular_errors)}, {"double", angular(result.angular_errors_exact)}};
  json["warnings"] = report.warnings;
  json["inputs"] = Json::array();
  for (const Scene::InputFile& input : scene.inputs) json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  if (report.configuration) json["config"] = configuration_json(*report.configuration);
  json["host"] = {{"wall_s", number(report.host.wall_s)},
                  {"fragments_per_s", number(report.host.fragments_per_s)},
                  {"peak_rss_mib", number(report.host.peak_rss_mib)},
                  {"compiler", report.host.compiler},
                  {"version", report.host.version}};
  for (const HostTime& time : result.host_times) json["host"]["parts_s"][time.part] = time.seconds;
  return json;
}

std::string json_text(const RunReport& report) {
  return to_json(report).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bump
