// `bumpsim fit`: the cheapest structure, widths and table sizes of schemes that reach a quality on the worst of several scenes.

#include <fmt/core.h>

#include <cmath>
#include <deque>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/fit.h"
#include "testbench/experiments/fit_formats.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/price_files.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"
#include "testbench/results/output_file.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

FitCostKind cost_of(const FitArguments& arguments, const PriceBook& book) {
  if (!arguments.cost.empty()) return cost_kind_of(arguments.cost);
  if (book.area != nullptr) return FitCostKind::area;
  return book.energy != nullptr ? FitCostKind::energy : FitCostKind::table_bits;
}

std::string in_format(const Fit& fit, const FitArguments& arguments) {
  if (arguments.json || arguments.format == "json") return fit_json(fit, version_text());
  if (arguments.format == "csv") return fit_csv(fit);
  return fit_document(fit, arguments.format == "md");
}

/// Returns the exit code.
int report_failures(const Fit& fit) {
  const FitRow* worst = worst_failure(fit);
  if (worst == nullptr) return 0;
  for (const FitRow& row : fit.rows)
    if (row.error) write_to_stderr(fmt::format("bumpsim: {}: {}\n", row.page->id, row.error->what()));
  return static_cast<int>(worst->error->kind());
}

}  // namespace

int fit_command(const FitArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  if (!std::isfinite(arguments.psnr_db)) throw Error({"--psnr is no number", {}, "the quality to reach is a ratio in dB", "--psnr 40"});
  if (!arguments.out.empty()) check_output_file(arguments.out, arguments.force);
  const std::vector<const Scheme*> schemes = schemes_of(arguments.schemes);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  const std::vector<PriceTable> tables = read_price_tables(arguments.prices);
  FitOptions options;
  options.psnr_db = arguments.psnr_db;
  options.against = arguments.against == "double" ? FitAgainst::own_double : FitAgainst::reference;
  options.book = make_price_book(tables);
  options.cost = cost_of(arguments, options.book);
  options.search_structure = arguments.structure == "search";
  options.limit = arguments.designs;
  options.jobs = arguments.jobs;
  options.cancelled = &interrupted;

  std::deque<Scene> read;
  std::vector<const Scene*> scenes;
  for (const std::string& name : arguments.scenes) {
    read.push_back(read_scene(scene_path(name)));
    for (const std::string& warning : read.back().warnings) warn(read.back().name + ": " + warning);
    scenes.push_back(&read.back());
  }
  for (const Scene* scene : scenes)
    for (const Scheme* scheme : schemes)
      for (const std::string& warning : warnings_of(*scene, scheme->page(), configuration)) warn(scene->name + ": " + warning);

  std::optional<Progress> progress;
  progress.emplace(fmt::format("fitting {} scheme{}", schemes.size(), schemes.size() == 1 ? "" : "s"));
  options.progress = [&progress](double share) { progress->update(share); };
  const Fit result = fit(scenes, schemes, configuration, options);
  progress.reset();
  stop_if_interrupted();
  const std::string text = in_format(result, arguments);
  if (arguments.out.empty())
    fmt::print("{}", text);
  else
    write_output_file(arguments.out, text, arguments.force);
  return report_failures(result);
}

}  // namespace bump
