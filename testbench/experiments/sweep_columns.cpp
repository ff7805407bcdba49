#include "testbench/experiments/sweep_columns.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "testbench/experiments/compare_metrics.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// Over what works per pixel, what a netlist needs beside the published count included; null for what no unit has.
Json total_built(const Json& metrics, const std::string& operators) {
  Json total;
  for (const std::string& unit : compared_units()) {
    if (unit == "frame") continue;
    for (const char* portion : {"_", "_additional_"}) {
      const Json& count = metrics.at(unit + portion + operators);
      if (count.is_number()) total = (total.is_null() ? 0 : total.get<std::int64_t>()) + count.get<std::int64_t>();
    }
  }
  return total;
}

Json shared_multipliers(const Json& result) {
  Json total;
  for (const std::string& unit : compared_units()) {
    const Json::json_pointer pointer("/operators/" + unit + "/multipliers_after_sharing");
    if (!result.contains(pointer) || !result.at(pointer).is_number()) continue;
    total = (total.is_null() ? 0 : total.get<std::int64_t>()) + result.at(pointer).get<std::int64_t>();
  }
  return total;
}

/// Of all copies.
Json table_bits(const Json& result) {
  Json total;
  if (!result.contains("tables")) return total;
  for (const Json& table : result.at("tables"))
    total = (total.is_null() ? 0 : total.get<std::int64_t>()) + table["bits"].get<std::int64_t>() * table["copies"].get<std::int64_t>();
  return total;
}

Json figures(const Json& result) {
  const Json metrics = metrics_of(result);
  Json figures;
  for (const auto& [name, value] : metrics.items()) {
    figures[name] = value;
    if (name != "frames_per_second") continue;
    for (const std::string& operators : operator_names()) figures["built_" + operators] = total_built(metrics, operators);
    figures["multipliers_after_sharing"] = shared_multipliers(result);
    figures["table_bits"] = table_bits(result);
  }
  return figures;
}

/// JSON has no infinities.
Json storable(const Json& value) {
  if (!value.is_number_float() || std::isfinite(value.get<double>())) return value;
  const double number = value.get<double>();
  return std::isnan(number) ? Json(nullptr) : Json(number > 0 ? "inf" : "-inf");
}

}  // namespace

const std::vector<std::string>& sweep_columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    const Json none = figures(Json::object());
    for (const auto& [name, value] : none.items()) list.push_back(name);
    return list;
  }();
  return names;
}

Json sweep_values(const Json& result) {
  Json values = Json::array();
  const Json all = figures(result);
  for (const auto& [name, value] : all.items()) values.push_back(storable(value));
  return values;
}

std::string reason_of(const Error& error) {
  const ErrorText& text = error.text();
  return text.what + (text.why.empty() ? "" : ": " + text.why) + (text.try_this.empty() ? "" : "; try " + text.try_this);
}

}  // namespace bump
