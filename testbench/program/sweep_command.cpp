// `bumpsim sweep`: runs the points of a specification that its folder does not have yet, and writes them as one table.

#include <fmt/core.h>

#include "system/simulation.h"
#include "testbench/experiments/sweep_run.h"
#include "testbench/experiments/sweep_tables.h"
#include "testbench/program/commands.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"

namespace bump {

namespace {

void print_summary(const SweepPlan& plan, const SweepSummary& summary, const std::string& out) {
  fmt::print("{} points", summary.points);
  if (summary.points != plan.points().size()) fmt::print(" of {}", plan.points().size());
  if (plan.repeated() > 0) fmt::print(", {} more were repetitions", plan.repeated());
  fmt::print("\n  {:<24}{:>8}\n", "finished before", summary.known);
  fmt::print("  {:<24}{:>8}\n", "simulations", summary.runs);
  fmt::print("  {:<24}{:>8}\n", "dated from their traces", summary.dated);
  fmt::print("  {:<24}{:>8}\n", "checked by full runs", summary.checked);
  for (const auto& [status, count] : summary.statuses) fmt::print("  {:<24}{:>8}\n", status, count);
  fmt::print("tables in {}\n  {}  {}  {}\n", out, sweep_csv_name, sweep_lines_name, sweep_manifest_name);
}

SweepSummary sweep_with_progress(const SweepPlan& plan, SweepRunOptions options) {
  Progress progress(fmt::format("sweeping {} points", plan.points().size()));
  options.progress = [&progress](double share) { progress.update(share); };
  return run_sweep(plan, options);
}

}  // namespace

int sweep_command(const SweepArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  SweepRunOptions options;
  options.out = arguments.out;
  options.version = version_text() + ", models " + models_digest();
  options.jobs = arguments.jobs;
  options.anew = arguments.force;
  options.cancelled = &interrupted;
  if (!arguments.shard.empty()) options.shard = shard_of(arguments.shard);
  options.check = check_share_of(arguments.check);
  const SweepPlan plan(read_sweep_spec(arguments.spec, all_parameters(), scene_folders()), options.version);
  for (const SweptScene& scene : plan.spec().scenes) warn_if_shadowed(scene.name);
  for (const Scene& scene : plan.scenes())
    for (const std::string& warning : scene.warnings) warn(scene.name + ": " + warning);

  const SweepSummary summary = sweep_with_progress(plan, options);
  for (const std::string& damage : summary.damages) warn(damage + ": what it was about ran again");
  if (arguments.json)
    fmt::print("{}\n", summary.manifest.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  else
    print_summary(plan, summary, arguments.out);
  std::size_t failed = 0;
  for (const auto& [status, count] : summary.statuses) failed += status == "ok" ? 0 : count;
  if (failed > 0) write_to_stderr(fmt::format("bumpsim: {} of {} points failed; their rows say why\n", failed, summary.points));
  return exit_code_of(summary.statuses);
}

}  // namespace bump
