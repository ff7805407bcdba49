#pragma once
// Writes a run's result folder: result.json, config.resolved.toml, stats.csv, frame.png, frame.exr and error.png (where a reference was
// drawn). The folder appears complete or not at all (pending_folder.h). No model of hardware.

#include <string>

#include "testbench/results/run_report.h"

namespace bump {

/// Throws Error(input) if the folder cannot be written or is in use; an earlier result of this program is replaced only with `force`.
void write_result(const std::string& out, const RunReport& report, bool force);

}  // namespace bump
