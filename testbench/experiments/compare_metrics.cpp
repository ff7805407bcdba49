#include "testbench/experiments/compare_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// Null for whatever the document lacks.
Json at(const Json& document, const std::string& path) {
  const Json::json_pointer pointer(path);
  return document.is_structured() && document.contains(pointer) ? document.at(pointer) : Json(nullptr);
}

Json ratio(const Json& part, const Json& whole, double scale = 1) {
  if (!part.is_number() || !whole.is_number() || whole.get<double>() == 0) return nullptr;
  return scale * part.get<double>() / whole.get<double>();
}

Json scaled(const Json& number, double scale) {
  return number.is_number() ? Json(number.get<double>() * scale) : Json(nullptr);
}

/// Of what a document has; null if that is nothing.
Json sum(const std::vector<Json>& numbers) {
  Json total;
  for (const Json& number : numbers)
    if (number.is_number()) total = (total.is_null() ? 0.0 : total.get<double>()) + number.get<double>();
  return total;
}

bool works_per_fragment(const std::string& unit) {
  const auto& units = compared_units();
  return unit != "frame" && std::find(units.begin(), units.end(), unit) != units.end();
}

Json used_per_fragment(const Json& result, const std::string& operators) {
  std::vector<Json> used;
  for (const std::string& unit : compared_units())
    if (works_per_fragment(unit)) used.push_back(at(result, "/operators/" + unit + "/used_per_fragment/" + operators));
  return sum(used);
}

/// Null without tables, as for a scheme that has none there is no size to speak of.
Json over_tables(const Json& result, const std::function<double(const Json&)>& value) {
  std::vector<Json> values;
  for (const Json& table : at(result, "/tables")) values.push_back(value(table));
  return sum(values);
}

Json table_reads(const Json& result) {
  return over_tables(result, [](const Json& table) { return works_per_fragment(table["unit"]) ? table["reads"].get<double>() : 0.0; });
}

/// Over all maps of the scheme; null for a scheme without.
Json over_light_maps(const Json& result, const std::string& name) {
  std::vector<Json> values;
  for (const Json& map : at(result, "/light_maps")) values.push_back(at(map, "/" + name));
  return sum(values);
}

/// Operations of all kinds that a unit executed in the whole run, table reads included.
Json operations_of(const Json& result, const std::string& unit) {
  std::vector<Json> used;
  for (const std::string& operators : operator_names())
    used.push_back(at(result, "/operators/" + unit + "/used_per_fragment/" + operators));
  const Json per_fragment = sum(used), fragments = at(result, "/fragments");
  return per_fragment.is_null() || fragments.is_null() ? Json(nullptr) : Json(per_fragment.get<double>() * fragments.get<double>());
}

/// A vertex program repeats a part of it for every further light.
Json vertex_operations(const Json& result) {
  return ratio(operations_of(result, "vertex"), at(result, "/operators/vertex/executions"));
}

/// What fills the light maps before the first pixel.
Json frame_operations(const Json& result) {
  return operations_of(result, "frame");
}

Json psnr(const Json& quality) {
  const Json ratio_db = at(quality, "/psnr_db"), pixels = at(quality, "/pixels");
  if (ratio_db.is_number()) return ratio_db;
  return pixels.is_number() && pixels > 0 ? Json(std::numeric_limits<double>::infinity()) : Json(nullptr);
}

Json light_angle(const Json& result) {
  for (const Json& error : at(result, "/angular_error/hardware"))
    if (at(error, "/vector") == "L'") return at(error, "/mean_degrees");
  return nullptr;
}

}  // namespace

const std::vector<std::string>& operator_names() {
  static const std::vector<std::string> names = {"multipliers", "adders", "dividers", "square_roots", "tables", "maps", "shifters"};
  return names;
}

const std::vector<std::string>& compared_units() {
  static const std::vector<std::string> units = {"environment", "illumination", "conversion", "light_map_address", "frame"};
  return units;
}

Json metrics_of(const Json& result) {
  constexpr double kilobytes_of_bits = 1.0 / 8192, kilobytes_of_bytes = 1.0 / 1024;
  const Json fragments = at(result, "/fragments");
  Json metrics;
  metrics["cycles"] = at(result, "/cycles");
  metrics["fragments"] = fragments;
  metrics["fragments_per_cycle"] = at(result, "/fragments_per_cycle");
  metrics["bound_cycles"] = at(result, "/bound/cycles");
  metrics["bound_reached_percent"] = ratio(at(result, "/bound/cycles"), at(result, "/cycles"), 100);
  metrics["bound_by"] = at(result, "/bound/by");
  metrics["frames_per_second"] = at(result, "/frames_per_second");

  for (const std::string& unit : compared_units()) {
    const std::string path = "/operators/" + unit;
    for (const std::string& name : operator_names()) metrics[unit + "_" + name] = at(result, path + "/built/" + name);
    for (const std::string& name : operator_names()) metrics[unit + "_additional_" + name] = at(result, path + "/additional/" + name);
  }
  for (const std::string& name : operator_names())
    if (name != "tables" && name != "maps") metrics[name + "_used_per_fragment"] = used_per_fragment(result, name);
  metrics["table_reads_per_fragment"] = ratio(table_reads(result), fragments);
  metrics["operations_per_frame"] = frame_operations(result);
  metrics["vertex_operations_per_vertex"] = vertex_operations(result);
  metrics["interpolated_components"] = at(result, "/interpolator_components");

  const auto bits = [](const Json& table) { return table["bits"].get<double>(); };
  const auto copied_bits = [](const Json& table) { return table["bits"].get<double>() * table["copies"].get<double>(); };
  metrics["tables_rom_kilobytes"] = scaled(over_tables(result, copied_bits), kilobytes_of_bits);
  metrics["tables_distinct_kilobytes"] = scaled(over_tables(result, bits), kilobytes_of_bits);

  metrics["texels_per_fragment"] = ratio(at(result, "/texture/reads"), fragments);
  metrics["texture_kilobytes"] = scaled(at(result, "/texture/bytes"), kilobytes_of_bytes);
  metrics["texture_hit_rate_percent"] = scaled(at(result, "/texture/hit_rate"), 100);
  metrics["light_map_reads_per_fragment"] = ratio(over_light_maps(result, "reads"), fragments);
  metrics["light_map_kilobytes"] = scaled(over_light_maps(result, "bytes"), kilobytes_of_bytes);
  metrics["light_map_hit_rate_percent"] = ratio(over_light_maps(result, "hits"), over_light_maps(result, "reads"), 100);
  metrics["light_map_filled_kilobytes"] = scaled(over_light_maps(result, "bytes_written"), kilobytes_of_bytes);

  metrics["psnr_hardware_to_reference_db"] = psnr(at(result, "/quality/against_reference"));
  metrics["psnr_double_to_reference_db"] = psnr(at(result, "/quality/double_against_reference"));
  metrics["psnr_hardware_to_double_db"] = psnr(at(result, "/quality/against_double"));
  metrics["psnr_hardware_to_blinn_db"] = psnr(at(result, "/quality/against_blinn"));
  metrics["max_error_steps_of_255"] = at(result, "/quality/against_reference/max_error");
  metrics["mean_angle_of_light_degrees"] = light_angle(result);
  return metrics;
}

}  // namespace bump
