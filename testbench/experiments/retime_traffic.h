#pragma once
// What re-timed caches found and moved, in the words of a run: for the rows of sweeps and for single configurations. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "retiming/retimer.h"
#include "testbench/results/text_table.h"

namespace bump {

/// Adds "texture", and "light_maps" for designs with light maps.
void add_traffic(nlohmann::ordered_json& json, const FetchTraffic& traffic, const LightMaps* maps);

/// Of a row of text: header and cells. All light maps together.
std::vector<std::string> traffic_header(const LightMaps* maps);
std::vector<std::string> traffic_cells(const FetchTraffic& traffic);
/// A table for a report on one configuration, a line for each cache client.
TextTable traffic_table(const FetchTraffic& traffic, const LightMaps* maps);

/// Of the tidy csv: "texture", "hits", "123", "lines" and so on.
struct TrafficStatistic {
  std::string module, statistic, value, unit;
};
std::vector<TrafficStatistic> traffic_statistics(const FetchTraffic& traffic, const LightMaps* maps);

}  // namespace bump
