// `bumpsim retime`: dates a recorded trace again, under one configuration or all points of a sweep, without computing a value.

#include <fmt/core.h>

#include <algorithm>

#include "retiming/trace_file.h"
#include "testbench/experiments/retime.h"
#include "testbench/experiments/retime_formats.h"
#include "testbench/program/commands.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"
#include "testbench/scene/config_file.h"
#include "testbench/scene/input_files.h"

namespace bump {

namespace {

int retime_once(Retimer& retimer, const Configuration& configuration, const std::string& format) {
  Progress progress("dating " + retimer.trace().scene);
  const RetimedRun run = retimer.retime(configuration, [&progress](double share) {
    progress.update(share);
    stop_if_interrupted();
  });
  fmt::print("{}", retimed_run_report(retimer, configuration, run, format, version_text()));
  return 0;
}

/// A point that deadlocks is a row; only if all do, the command has failed.
int exit_code(const std::vector<SweepRow>& rows) {
  const auto failed =
      static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return row.error.has_value(); }));
  if (failed > 0) write_to_stderr(fmt::format("bumpsim: {} of {} points deadlock\n", failed, rows.size()));
  return failed == rows.size() ? static_cast<int>(ErrorKind::deadlock) : 0;
}

int retime_grid(Retimer& retimer, const Configuration& base, const SweepGrid& grid, const RetimeArguments& arguments,
                const std::string& format, const std::atomic<bool>& interrupted) {
  std::vector<SweepRow> rows;
  {
    Progress progress(fmt::format("dating {} points of {}", grid.points(), retimer.trace().scene));
    SweepOptions options;
    options.jobs = arguments.jobs;
    options.progress = [&progress](double share) { progress.update(share); };
    options.cancelled = &interrupted;
    rows = sweep(retimer, base, grid, options);
  }
  fmt::print("{}", sweep_report(retimer, base, grid, rows, format, version_text()));
  return exit_code(rows);
}

}  // namespace

int retime_command(const RetimeArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  const std::string format = arguments.json ? "json" : arguments.format;
  Retimer retimer(decode_trace(read_bytes(arguments.trace, "timing trace"), arguments.trace), all_parameters(), arguments.trace);

  Configuration configuration = retimer.recorded();
  for (const std::string& file : arguments.configuration_files) read_configuration(file, configuration);
  for (const std::string& setting : arguments.settings) apply_setting(setting, configuration);
  retimer.check(configuration);
  const SweepGrid grid(arguments.sweeps, configuration.parameters());
  for (const SweepAxis& axis : grid.axes()) {
    if (!(configuration.entries().at(axis.key).value == retimer.recorded().entries().at(axis.key).value))
      throw Error({axis.key + " is both set and swept", {}, "", "leave out --set, or that --sweep"});
    for (const ParameterValue& value : axis.values) {
      Configuration point = retimer.recorded();
      point.set(axis.key, value, {"--sweep", 0, 0});
      retimer.check(point);
    }
  }
  if (grid.axes().empty()) return retime_once(retimer, configuration, format);
  return retime_grid(retimer, configuration, grid, arguments, format, interrupted);
}

}  // namespace bump
