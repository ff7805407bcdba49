#pragma once
// What a user sees first after a run: one screen of aligned text, under 100 columns. Published counts stand beside the derived ones and are
// used for nothing. No model of hardware.

#include <string>

#include "testbench/results/run_report.h"

namespace bump {

std::string summary(const RunReport& report);

}  // namespace bump
