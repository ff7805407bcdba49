// `bumpsim price`: what schemes cost in area and energy by tables of prices, and at which cost of tables two of them are equal.

#include <fmt/core.h>

#include <algorithm>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/price_report.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/price_files.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/warning.h"
#include "testbench/results/output_file.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

std::array<const Scheme*, 2> pair_of(const std::string& text) {
  const std::vector<const Scheme*> schemes = schemes_of(text);
  if (schemes.size() == 1 && text.find(',') != std::string::npos)
    throw Error({"--break-even names " + schemes.front()->page().id + " twice",
                 {},
                 "a scheme costs what it costs: there is nothing to compare",
                 "--break-even " + schemes.front()->page().id + (schemes.front()->page().id == "peercy1997" ? ",lee2007" : ",peercy1997")});
  if (schemes.size() != 2)
    throw Error({fmt::format("--break-even names {} scheme{}", schemes.size(), schemes.size() == 1 ? "" : "s"),
                 {},
                 "it compares two",
                 "--break-even lee2007,exact_polar"});
  return {schemes[0], schemes[1]};
}

/// What was asked for, then what else a break-even needs.
std::vector<const Scheme*> all_of(const PriceArguments& arguments, const std::optional<std::array<const Scheme*, 2>>& pair) {
  std::vector<const Scheme*> schemes;
  if (!arguments.schemes.empty() || !pair) schemes = schemes_of(arguments.schemes.empty() ? "all" : arguments.schemes);
  if (pair)
    for (const Scheme* scheme : *pair)
      if (std::find(schemes.begin(), schemes.end(), scheme) == schemes.end()) schemes.push_back(scheme);
  return schemes;
}

/// Returns the exit code.
int report_failures(const PriceReport& report) {
  const SchemePrice* worst = worst_failure(report);
  if (worst == nullptr) return 0;
  for (const SchemePrice& price : report.schemes)
    if (price.error) write_to_stderr(fmt::format("bumpsim: {}: {}\n", price.page->id, price.error->what()));
  return static_cast<int>(worst->error->kind());
}

}  // namespace

int price_command(const PriceArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  if (!arguments.out.empty()) check_output_file(arguments.out, arguments.force);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  PriceReportOptions options;
  if (!arguments.break_even.empty()) options.break_even = pair_of(arguments.break_even);
  options.schemes = all_of(arguments, options.break_even);
  options.real_bits = arguments.real_bits;
  const std::vector<PriceTable> tables =
      read_price_tables(arguments.prices.empty() ? std::vector<std::string>{"osu018_model", "horowitz45"} : arguments.prices);

  Scene scene;
  std::optional<Progress> progress;
  if (!arguments.scene.empty()) {
    scene = read_scene(scene_path(arguments.scene));
    for (const std::string& warning : scene.warnings) warn(warning);
    options.scene = &scene;
    options.work.jobs = arguments.jobs;
    options.work.cancelled = &interrupted;
    progress.emplace("counting work on " + scene.name);
    options.work.progress = [&](double share) { progress->update(share); };
  }
  const PriceReport report = make_price_report(configuration, make_price_book(tables), options);
  progress.reset();
  if (report.schemes.size() == 1 && report.schemes.front().error) throw *report.schemes.front().error;
  stop_if_interrupted();
  const std::string text = format_price_report(report, arguments.json ? "json" : arguments.format, arguments.items);
  if (arguments.out.empty())
    fmt::print("{}", text);
  else
    write_output_file(arguments.out, text, arguments.force);
  return report_failures(report);
}

}  // namespace bump
