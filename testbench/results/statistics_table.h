#pragma once
// stats.csv: every count and measure of a run as one flat table of module, statistic, value and unit, for spreadsheets and plotting. What
// the statistics of stages, FIFOs and memories mean stands in channels/statistics.h; of all others here. No model of hardware.

#include <string>
#include <vector>

#include "channels/statistics.h"
#include "testbench/results/run_report.h"

namespace bump {

struct StatisticRow {
  std::string module;  ///< "run", the name of a stage, FIFO or memory, "operators.environment", "table.environment.SC",
                       ///< "light_map.diffuse", "quality.against_reference" ...
  std::string statistic;  ///< "busy", "psnr_db" ...
  std::string value;      ///< shortest text that reads back as the same number; "" when not applicable; "inf" for identical images
  std::string unit;       ///< "cycles", "dB", "1" for pure numbers
};

std::vector<StatisticRow> statistic_rows(const RunReport& report);

/// Meanings of the statistics that statistic_meanings() does not list, by kind of module: "run", "operators", "table", "texture",
/// "light_map", "geometry", "quality", "angular_error".
std::vector<StatisticMeaning> result_statistic_meanings();

/// The rows with a header, RFC 4180 quoting, lines ended by "\n".
std::string to_csv(const std::vector<StatisticRow>& rows);

}  // namespace bump
