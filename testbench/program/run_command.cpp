// `bumpsim run`: reads the scene, simulates, measures the picture against the references, writes the result folder, prints the summary.

#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "retiming/trace_file.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/retime.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/trace_file.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"
#include "testbench/reference/cores.h"
#include "testbench/results/output_file.h"
#include "testbench/results/pending_folder.h"
#include "testbench/results/result_folder.h"
#include "testbench/results/result_json.h"
#include "testbench/results/summary.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// The first of out/<scene>-<scheme>, out/<scene>-<scheme>-2 ... that does not exist: an earlier result is never touched.
std::string new_output_folder(const std::string& scene, const std::string& scheme) {
  const fs::path base = fs::path("out") / (scene + "-" + scheme);
  fs::path folder = base;
  for (int number = 2; fs::exists(fs::symlink_status(folder)); ++number) folder = base.string() + "-" + std::to_string(number);
  return folder.string();
}

void check_trace(const RunArguments& arguments) {
  if (engine_of(arguments.engine) == Engine::dated && !arguments.trace.empty())
    throw Error({"--trace needs the clocked engine",
                 {},
                 "the dated engine has no signals to write",
                 "--engine stepped --trace " + arguments.trace});
  const auto same_file = [](const fs::path& a, const fs::path& b) {
    return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
  };
  if (!arguments.trace.empty() && !arguments.record.empty() &&
      (same_file(arguments.trace, arguments.record) || same_file(arguments.trace + ".vcd", arguments.record)))
    throw Error({"--trace and --record name the same file", {arguments.record}, "", "another file for one of them"});
}

/// Frames go as soon as nothing is measured with them any more.
void measure(MeasuredRun& run, References references, int jobs) {
  run.measure(references, jobs);
  references.blinn.reset();
  run.draw_error_picture(std::move(references.normal_map), jobs);
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  check_trace(arguments);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  const Scheme& scheme = find_scheme(arguments.scheme);
  if (!arguments.out.empty()) check_output_folder(arguments.out, arguments.force);
  const Scene scene = read_scene(scene_path(arguments.scene));
  for (const std::string& warning : scene.warnings) warn(warning);
  for (const std::string& warning : warnings_of(scene, scheme.page(), configuration)) warn(warning);
  const std::string out = arguments.out.empty() ? new_output_folder(scene.name, arguments.scheme) : arguments.out;
  check_output_folder(out, arguments.force);

  if (!arguments.record.empty()) check_record_file(arguments.record, out, arguments.force);
  TraceFile trace(arguments.trace, out, arguments.force);

  SimulationOptions options;
  const int jobs = arguments.jobs > 0 ? arguments.jobs : cores_of_process();
  options.measure = !arguments.no_quality;
  options.measure_aside = jobs > 1;
  options.trace = trace.stem();
  options.cancelled = &interrupted;
  Progress progress("simulating " + scene.name);
  options.progress = [&progress](double share) { progress.update(share); };
  TraceRecorder recorder;
  if (!arguments.record.empty()) options.record = [&recorder](const TimingRecords& records) { recorder.add(records); };
  if (arguments.addresses) options.accesses = &recorder.accesses();
  MeasuredRun run(scene, scheme, configuration, arguments.engine);
  std::optional<ReferenceDrawing> drawing;
  if (!arguments.no_quality) drawing.emplace(scene, configuration, &interrupted).begin(jobs - 1);
  run.simulate(options);
  trace.check(run.result().timing.cycles);
  for (const std::string& warning : run.warnings()) warn(warning);
  if (drawing) measure(run, drawing->finish(), jobs);

  RunReport& report = run.report();
  report.host = host_facts(run.wall_s(), run.result().fragments, compiler_text(), version_text());
  stop_if_interrupted();
  report.out = out;
  if (!arguments.record.empty())
    write_output_file(arguments.record, encode_trace(recorder.finish(scene, scheme, configuration, run.result().timing.cycles)),
                      arguments.force, "--record");
  write_result(out, report, arguments.force);
  trace.commit();
  fmt::print("{}", arguments.json ? json_text(report) : summary(report));
  return 0;
}

}  // namespace bump
