#include "testbench/experiments/fit_bench.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>

#include "datapath/invariant.h"
#include "system/simulation.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/reference/quality.h"

namespace bump {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string bytes_of(const FitQuality& quality) {
  return {reinterpret_cast<const char*>(&quality), sizeof quality};
}

FitQuality quality_from(const std::string& bytes) {
  FitQuality quality;
  BUMP_ASSERT(bytes.size() == sizeof quality);
  std::memcpy(&quality, bytes.data(), sizeof quality);
  return quality;
}

double psnr(const Quality& quality, const Scene& scene) {
  if (quality.pixels == 0)
    throw Error({"scene '" + scene.name + "' shows nothing: there is no picture to measure", {}, "", "another camera, or another scene"});
  return quality.psnr_db;
}

/// The quality that is asked for, in a process of its own.
FitQuality measured_while_searching(const FitScenes& bench, std::size_t scene, const Scheme& scheme, const Configuration& configuration) {
  const bool own = bench.options.against == FitAgainst::own_double;
  SimulationOptions options;
  options.engine = Engine::untimed;
  options.measure = own;
  const SimulationResult result = simulate(*bench.scenes[scene], scheme, configuration, options);
  FitQuality quality;
  (own ? quality.to_double : quality.to_reference) =
      psnr(compare_frames(result.hardware, own ? result.exact : bench.references[scene].normal_map), *bench.scenes[scene]);
  return quality;
}

/// As any run, self-check included.
FitQuality measured_in_full(const FitScenes& bench, std::size_t scene, const Scheme& scheme, const Configuration& configuration) {
  MeasuredRun run(*bench.scenes[scene], scheme, configuration, "dated");
  run.simulate({});
  run.measure(bench.references[scene]);
  const RunReport& report = run.report();
  return {psnr(*report.against_reference, *bench.scenes[scene]), psnr(*report.against_double, *bench.scenes[scene]),
          psnr(*report.double_against_reference, *bench.scenes[scene])};
}

using Measurement = FitQuality (*)(const FitScenes&, std::size_t, const Scheme&, const Configuration&);

}  // namespace

FitBench::FitBench(const FitScenes& scenes, const Scheme& scheme, std::function<void(double)> progress)
    : scenes_(scenes), scheme_(scheme), progress_(std::move(progress)), was_worst_(scenes.scenes.size(), 0) {}

DesignSize FitBench::size(const Configuration& configuration, std::int64_t width_sum) const {
  DesignSize size = design_size(scheme_, configuration, scenes_.options.book);
  size.width_sum = width_sum;
  return size;
}

std::optional<FitCost> FitBench::cost(const Configuration& configuration, std::int64_t width_sum) {
  try {
    return cost_of(size(configuration, width_sum), scenes_.options.cost);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    if (!first_error_) first_error_ = error;
    return std::nullopt;
  }
}

std::string FitBench::settings_of(const Configuration& configuration) const {
  std::string text;
  for (const auto& [key, entry] : configuration.entries())
    if (key.rfind(scheme_.page().id + ".", 0) == 0) text += to_string(entry.value) + " ";
  return text;
}

double FitBench::worst_of(const OnScenes& qualities) {
  double worst = infinity;
  for (const std::optional<double>& quality : qualities) worst = std::min(worst, quality.value_or(infinity));
  return worst;
}

std::size_t FitBench::hardest_scene() const {
  return static_cast<std::size_t>(std::max_element(was_worst_.begin(), was_worst_.end()) - was_worst_.begin());
}

void FitBench::count_hardest(const OnScenes& qualities) {
  for (std::size_t i = 0; i < qualities.size(); ++i)
    if (qualities[i] && *qualities[i] == worst_of(qualities)) ++was_worst_[i];
}

std::vector<double> FitBench::worst(const std::vector<Configuration>& designs, double floor) {
  std::vector<std::string> settings;
  std::vector<Task> first, others;
  std::set<std::string> asked;
  const std::size_t hardest = hardest_scene();
  for (const Configuration& design : designs) {
    settings.push_back(settings_of(design));
    OnScenes& known = known_[settings.back()];
    known.resize(scenes_.scenes.size());
    if (!known[hardest] && asked.insert(settings.back()).second) first.push_back({&design, hardest});
  }
  measure(first);
  asked.clear();
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const OnScenes& known = known_.at(settings[i]);
    if (worst_of(known) < floor || worst_of(known) == -infinity || !asked.insert(settings[i]).second) continue;
    for (std::size_t scene = 0; scene < known.size(); ++scene)
      if (!known[scene]) others.push_back({&designs[i], scene});
  }
  measure(others);
  std::vector<double> qualities;
  for (const std::string& one : settings) qualities.push_back(worst_of(known_.at(one)));
  for (const std::string& one : asked) count_hardest(known_.at(one));
  return qualities;
}

void FitBench::measure(const std::vector<Task>& tasks) {
  if (tasks.empty()) return;
  std::vector<ChildTask> children;
  for (const Task& task : tasks)
    children.push_back({name_of(task), [this, task](const ReportShare&) {
                          return bytes_of(measured_while_searching(scenes_, task.scene, scheme_, *task.design));
                        }});
  const std::vector<ChildOutcome> outcomes = run_in_children(children, child_options());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    std::optional<double>& quality = known_.at(settings_of(*tasks[i].design))[tasks[i].scene];
    if (outcomes[i].error) {
      if (outcomes[i].error->kind() == ErrorKind::internal) throw *outcomes[i].error;
      if (!first_error_) first_error_ = outcomes[i].error;
      failed_.insert(settings_of(*tasks[i].design));
      quality = -infinity;
      continue;
    }
    const FitQuality found = quality_from(outcomes[i].bytes);
    quality = scenes_.options.against == FitAgainst::own_double ? found.to_double : found.to_reference;
  }
  progress_(static_cast<double>(measured()) / scenes_.options.limit);
}

std::string FitBench::name_of(const Task& task) const {
  return scheme_.page().id + " on " + scenes_.scenes[task.scene]->name;
}

ChildOptions FitBench::child_options() const {
  ChildOptions options;
  options.jobs = scenes_.options.jobs;
  options.cancelled = scenes_.options.cancelled;
  return options;
}

std::vector<FitQuality> FitBench::in_full(const Configuration& design) const {
  std::vector<ChildTask> tasks;
  for (std::size_t scene = 0; scene < scenes_.scenes.size(); ++scene)
    tasks.push_back({name_of({&design, scene}),
                     [this, &design, scene](const ReportShare&) { return bytes_of(measured_in_full(scenes_, scene, scheme_, design)); }});
  std::vector<FitQuality> qualities;
  for (const ChildOutcome& outcome : run_in_children(tasks, child_options())) {
    if (outcome.error) throw *outcome.error;
    qualities.push_back(quality_from(outcome.bytes));
  }
  return qualities;
}

}  // namespace bump
