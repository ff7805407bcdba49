#pragma once
// The work of a sweep in one process: a point by a run, or a group of points by one run whose trace is dated again for each of them
// (../../sc_models/retiming). Both leave the same lines. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/experiments/sweep_plan.h"
#include "testbench/reference/reference_renderer.h"

namespace bump {

/// What the journal holds of a point that failed. `error` is what a run of it says.
std::string failure_line(const std::string& id, const Error& error);

/// A point by a run of its own: its line. Failures of the point are lines too. Throws Error(internal), which a line would make last, and
/// what is no matter of the point (memory). `references`: null if nothing is measured.
std::string run_point(const SweepPlan& plan, std::size_t point, const References* references, const ReportShare& report_share);

/// Points of a group with several members by one run, their lines appended to the journal as they are done. Where `wanted` is not all of
/// the members the others are left out. `threads`: of dating.
void run_group(const SweepPlan& plan, const PointGroup& group, const std::vector<std::size_t>& wanted, const References* references,
               int threads, const SweepJournal& journal, const ReportShare& report_share);

/// Where two lines of a point differ in status or figures: "cycles is 10, and 12 by a run of its own"; empty if nowhere. Failures agree if
/// they are of the same kind.
std::string difference(const nlohmann::ordered_json& retimed, const nlohmann::ordered_json& run);

}  // namespace bump
