// `bumpsim compare`: simulates several schemes on one scene, each in a process of its own, and prints their figures side by side.

#include <fmt/core.h>

#include "testbench/experiments/compare.h"
#include "testbench/experiments/compare_formats.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"
#include "testbench/results/image_file.h"
#include "testbench/results/pending_folder.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

constexpr FolderKind comparison_folder_kind = {
    "comparison", comparison_schema, {"compare.json", "compare.txt", "compare.md", "compare.csv", "compare.png", ""}};

void write_comparison(const std::string& out, const Comparison& comparison, bool force) {
  PendingFolder folder(out, force, comparison_folder_kind);
  folder.write("compare.txt", comparison_text(comparison));
  folder.write("compare.md", comparison_markdown(comparison));
  folder.write("compare.csv", comparison_csv(comparison));
  folder.write("compare.png", encode_png(picture_of(comparison)));
  folder.write("compare.json", comparison_json(comparison, version_text()));  // last: without it a folder is no comparison
  stop_if_interrupted();
  folder.commit();
}

std::string in_format(const Comparison& comparison, const CompareArguments& arguments) {
  if (arguments.json || arguments.format == "json") return comparison_json(comparison, version_text());
  if (arguments.format == "csv") return comparison_csv(comparison);
  return arguments.format == "md" ? comparison_markdown(comparison) : comparison_text(comparison);
}

/// Which schemes failed and which of them the exit code tells of. Returns that code.
int report_failures(const Comparison& comparison) {
  const ComparisonRow* worst = worst_failure(comparison);
  if (worst == nullptr) return 0;
  int failed = 0;
  for (const ComparisonRow& row : comparison.rows) {
    if (!row.error) continue;
    write_to_stderr(fmt::format("bumpsim: {}: {}\n", row.page->id, row.error->what()));
    ++failed;
  }
  const int code = static_cast<int>(worst->error->kind());
  write_to_stderr(
      fmt::format("bumpsim: {} of {} schemes failed; exit code {}, for {}\n", failed, comparison.rows.size(), code, worst->page->id));
  return code;
}

Comparison compare_with_progress(const Scene& scene, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
                                 const CompareArguments& arguments, const std::atomic<bool>& interrupted) {
  Progress progress("comparing on " + scene.name);
  ComparisonOptions options;
  options.engine = arguments.engine;
  options.jobs = arguments.jobs;
  options.picture = !arguments.out.empty();
  options.progress = [&](double share) { progress.update(share); };
  options.cancelled = &interrupted;
  return compare(scene, schemes, configuration, options);
}

}  // namespace

int compare_command(const CompareArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  engine_of(arguments.engine);
  const std::vector<const Scheme*> schemes = schemes_of(arguments.schemes);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  if (!arguments.out.empty()) check_output_folder(arguments.out, arguments.force, comparison_folder_kind);
  const Scene scene = read_scene(scene_path(arguments.scene));
  for (const std::string& warning : scene.warnings) warn(warning);

  const Comparison comparison = compare_with_progress(scene, schemes, configuration, arguments, interrupted);
  for (const std::string& warning : comparison.warnings) warn(warning);
  stop_if_interrupted();
  const bool written = !arguments.out.empty() && !is_void(comparison);
  if (written) write_comparison(arguments.out, comparison, arguments.force);
  fmt::print("{}", in_format(comparison, arguments));
  if (written && !arguments.json && arguments.format == "text")
    fmt::print("\ncomparison in {}\n  compare.json  compare.txt  compare.md  compare.csv  compare.png\n", arguments.out);
  if (!arguments.out.empty() && !written) write_to_stderr("bumpsim: no scheme has a result: nothing was written\n");
  return report_failures(comparison);
}

}  // namespace bump
