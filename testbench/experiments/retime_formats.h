#pragma once
// What re-timing says, as text, CSV and JSON: of one configuration all statistics of time that a run reports, of a sweep one row for each
// point. Not applicable is "-", an empty field, or null. No model of hardware.

#include <string>
#include <vector>

#include "testbench/experiments/retime.h"

namespace bump {

constexpr const char* retiming_schema = "bumpsim-retiming";
constexpr int retiming_schema_version = 1;

/// `format`: "text", "csv" or "json". `version` is the program's.
std::string retimed_run_report(const Retimer& retimer, const Configuration& configuration, const RetimedRun& run, const std::string& format,
                               const std::string& version);
std::string sweep_report(const Retimer& retimer, const Configuration& base, const SweepGrid& grid, const std::vector<SweepRow>& rows,
                         const std::string& format, const std::string& version);

}  // namespace bump
