#include "testbench/experiments/retime_traffic.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "testbench/results/run_report.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string percent(const std::optional<double>& rate) {
  return rate ? fmt::format("{:.2f} %", 100 * *rate) : "-";
}

std::string kilobytes(std::int64_t bytes) {
  return fmt::format("{:.1f}", static_cast<double>(bytes) / 1024);
}

LightMapCounters total(const std::vector<LightMapCounters>& maps) {
  LightMapCounters sum;
  for (const LightMapCounters& map : maps) {
    sum.reads += map.reads;
    sum.hits += map.hits;
    sum.misses += map.misses;
    sum.bytes += map.bytes;
  }
  return sum;
}

}  // namespace

void add_traffic(Json& json, const FetchTraffic& traffic, const LightMaps* maps) {
  const TextureCounters& t = traffic.texture;
  json["texture"] = {{"reads", t.reads},   {"accesses", t.accesses},          {"hits", t.hits},
                     {"misses", t.misses}, {"hit_rate", number(hit_rate(t))}, {"bytes", t.bytes}};
  if (maps == nullptr) return;
  json["light_maps"] = Json::array();
  for (std::size_t i = 0; i < traffic.light_maps.size(); ++i) {
    const LightMapCounters& m = traffic.light_maps[i];
    json["light_maps"].push_back({{"name", maps->maps[i].name},
                                  {"reads", m.reads},
                                  {"hits", m.hits},
                                  {"misses", m.misses},
                                  {"hit_rate", number(hit_rate(m))},
                                  {"bytes", m.bytes}});
  }
}

std::vector<std::string> traffic_header(const LightMaps* maps) {
  std::vector<std::string> header = {"texture hits", "texture KB"};
  if (maps != nullptr) header.insert(header.end(), {"light-map hits", "light-map KB"});
  return header;
}

std::vector<std::string> traffic_cells(const FetchTraffic& traffic) {
  std::vector<std::string> cells = {percent(hit_rate(traffic.texture)), kilobytes(traffic.texture.bytes)};
  if (traffic.light_maps.empty()) return cells;
  const LightMapCounters sum = total(traffic.light_maps);
  cells.insert(cells.end(), {percent(hit_rate(sum)), kilobytes(sum.bytes)});
  return cells;
}

TextTable traffic_table(const FetchTraffic& traffic, const LightMaps* maps) {
  TextTable table{{"caches", "look-ups", "hits", "misses", "KB from memory"}, {}, 1};
  const TextureCounters& t = traffic.texture;
  table.rows.push_back({"texture", std::to_string(t.accesses), percent(hit_rate(t)), std::to_string(t.misses), kilobytes(t.bytes)});
  for (std::size_t i = 0; maps != nullptr && i < traffic.light_maps.size(); ++i) {
    const LightMapCounters& m = traffic.light_maps[i];
    table.rows.push_back(
        {"light map " + maps->maps[i].name, std::to_string(m.reads), percent(hit_rate(m)), std::to_string(m.misses), kilobytes(m.bytes)});
  }
  return table;
}

std::vector<TrafficStatistic> traffic_statistics(const FetchTraffic& traffic, const LightMaps* maps) {
  std::vector<TrafficStatistic> rows;
  const auto rate = [](const std::optional<double>& value) { return value ? to_string(ParameterValue(*value)) : ""; };
  const TextureCounters& t = traffic.texture;
  rows.push_back({"texture", "reads", std::to_string(t.reads), "texels"});
  rows.push_back({"texture", "accesses", std::to_string(t.accesses), "lines"});
  rows.push_back({"texture", "hits", std::to_string(t.hits), "lines"});
  rows.push_back({"texture", "misses", std::to_string(t.misses), "lines"});
  rows.push_back({"texture", "hit_rate", rate(hit_rate(t)), "1"});
  rows.push_back({"texture", "bytes", std::to_string(t.bytes), "bytes"});
  for (std::size_t i = 0; maps != nullptr && i < traffic.light_maps.size(); ++i) {
    const LightMapCounters& m = traffic.light_maps[i];
    const std::string name = "light_map." + maps->maps[i].name;
    rows.push_back({name, "reads", std::to_string(m.reads), "words"});
    rows.push_back({name, "hits", std::to_string(m.hits), "words"});
    rows.push_back({name, "misses", std::to_string(m.misses), "words"});
    rows.push_back({name, "hit_rate", rate(hit_rate(m)), "1"});
    rows.push_back({name, "bytes", std::to_string(m.bytes), "bytes"});
  }
  return rows;
}

}  // namespace bump
