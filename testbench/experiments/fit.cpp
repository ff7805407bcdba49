#include "testbench/experiments/fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "datapath/invariant.h"
#include "system/simulation.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/fit_widths.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/reference/cores.h"
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

/// What all measurements share.
struct Bench {
  const std::vector<const Scene*>& scenes;
  const std::vector<References>& references;
  const FitOptions& options;

  ChildOptions children() const {
    ChildOptions children;
    children.jobs = options.jobs;
    children.cancelled = options.cancelled;
    return children;
  }
};

/// The quality that is asked for, in a process of its own.
FitQuality measured_while_searching(const Bench& bench, std::size_t scene, const Scheme& scheme, const Configuration& configuration) {
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
FitQuality measured_in_full(const Bench& bench, std::size_t scene, const Scheme& scheme, const Configuration& configuration) {
  MeasuredRun run(*bench.scenes[scene], scheme, configuration, "dated");
  run.simulate({});
  run.measure(bench.references[scene]);
  const RunReport& report = run.report();
  return {psnr(*report.against_reference, *bench.scenes[scene]), psnr(*report.against_double, *bench.scenes[scene]),
          psnr(*report.double_against_reference, *bench.scenes[scene])};
}

/// One scheme.
class SchemeFit {
 public:
  SchemeFit(const Bench& bench, const Scheme& scheme, const Configuration& configuration, std::function<void(double)> progress)
      : bench_(bench), scheme_(scheme), configuration_(configuration), progress_(std::move(progress)) {
    row_.page = &scheme.page();
  }

  FitRow run() {
    try {
      search();
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) throw;
      row_.error = error;
    }
    return std::move(row_);
  }

 private:
  void search() {
    FitParameters parameters = fit_parameters(scheme_, configuration_);
    row_.keys = parameters.keys;
    row_.set = std::move(parameters.set);
    row_.idle = std::move(parameters.idle);
    FitProblem problem;
    problem.ranges = row_.ranges = std::move(parameters.ranges);
    problem.target = bench_.options.psnr_db;
    problem.limit = bench_.options.limit;
    problem.cost = [this](const Widths& widths) { return cost(widths); };
    problem.measure = [this](const std::vector<Widths>& designs) { return measure(designs); };
    const FitAnswer answer = search_widths(problem);
    row_.measured = answer.measured;
    BUMP_ASSERT(answer.quality > -infinity || first_error_);
    if (answer.quality == -infinity) throw *first_error_;
    row_.widths = answer.widths;
    row_.reached = answer.reached;
    row_.complete = answer.complete;
    row_.size = size(answer.widths);
    confirm(answer.quality);
  }

  DesignSize size(const Widths& widths) const {
    DesignSize size = design_size(scheme_, with_widths(configuration_, row_.keys, widths), bench_.options.book);
    for (const int width : widths) size.width_sum += width;
    return size;
  }

  std::optional<FitCost> cost(const Widths& widths) {
    try {
      return cost_of(size(widths), bench_.options.cost);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      if (!first_error_) first_error_ = error;
      return std::nullopt;
    }
  }

  template <class Work>
  std::vector<ChildOutcome> on_all_scenes(const std::vector<Widths>& designs, const ChildOptions& options, const Work& work) const {
    std::vector<Configuration> configurations;
    for (const Widths& widths : designs) configurations.push_back(with_widths(configuration_, row_.keys, widths));
    std::vector<ChildTask> tasks;
    for (const Configuration& configuration : configurations)
      for (std::size_t scene = 0; scene < bench_.scenes.size(); ++scene)
        tasks.push_back({scheme_.page().id + " on " + bench_.scenes[scene]->name, [this, &work, &configuration, scene](const ReportShare&) {
                           return bytes_of(work(bench_, scene, scheme_, configuration));
                         }});
    return run_in_children(tasks, options);
  }

  /// The worst of the scenes for each.
  std::vector<double> measure(const std::vector<Widths>& designs) {
    ChildOptions options = bench_.children();
    const double before = done_, share = static_cast<double>(designs.size()) / bench_.options.limit;
    options.progress = [&](double part) { progress_(before + share * part); };
    const std::vector<ChildOutcome> outcomes = on_all_scenes(designs, options, measured_while_searching);
    done_ = before + share;
    std::vector<double> worst(designs.size(), infinity);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      double& quality = worst[i / bench_.scenes.size()];
      if (outcomes[i].error) {
        if (outcomes[i].error->kind() == ErrorKind::internal) throw *outcomes[i].error;
        if (!first_error_) first_error_ = outcomes[i].error;
        row_.failed += quality > -infinity ? 1 : 0;
        quality = -infinity;
        continue;
      }
      const FitQuality found = quality_from(outcomes[i].bytes);
      quality = std::min(quality, bench_.options.against == FitAgainst::own_double ? found.to_double : found.to_reference);
    }
    return worst;
  }

  void confirm(double quality) {
    for (const ChildOutcome& outcome : on_all_scenes({row_.widths}, bench_.children(), measured_in_full)) {
      if (outcome.error) throw *outcome.error;
      row_.qualities.push_back(quality_from(outcome.bytes));
    }
    const double again = row_.worst(bench_.options.against == FitAgainst::own_double ? &FitQuality::to_double : &FitQuality::to_reference);
    if (again != quality)
      throw Error(ErrorKind::self_check, {fmt::format("self-check failed: a run of the design found gives {:.6f} dB", again),
                                          {},
                                          fmt::format("{:.6f} dB was measured while searching", quality),
                                          "report this with the command that led to it"});
  }

  const Bench& bench_;
  const Scheme& scheme_;
  const Configuration& configuration_;
  std::function<void(double)> progress_;
  FitRow row_;
  double done_ = 0;
  std::optional<Error> first_error_;
};

void check(const std::vector<const Scene*>& scenes, const Configuration& configuration, const FitOptions& options) {
  if (configuration.choice("numeric") != "fixed")
    throw Error(
        {"widths mean nothing with numeric = double", {}, "a fit looks for the widths of fixed-point words", "numeric=fixed, the default"});
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (scenes[i]->name == scenes[j]->name)
        throw Error({"two scenes are called '" + scenes[i]->name + "'",
                     {},
                     "rows tell scenes apart by name",
                     "each scene once, under a name of its own"});
  for (const auto& [kind, quantity] : {std::pair{FitCostKind::area, Quantity::area}, std::pair{FitCostKind::energy, Quantity::energy}})
    if (options.cost == kind && options.book.of(quantity) == nullptr)
      throw Error({std::string("no table of prices for --cost ") + name_of(kind),
                   {},
                   "",
                   "--prices with a table of " + std::string(name_of(quantity))});
}

}  // namespace

double FitRow::worst(double FitQuality::*which) const {
  double least = infinity;
  for (const FitQuality& quality : qualities) least = std::min(least, quality.*which);
  return least;
}

bool FitRow::is_narrowest() const {
  for (std::size_t i = 0; i < widths.size(); ++i)
    if (widths[i] > ranges[i].low) return false;
  return !widths.empty();
}

double Fit::worst(const FitRow& row) const {
  return row.worst(options.against == FitAgainst::own_double ? &FitQuality::to_double : &FitQuality::to_reference);
}

Fit fit(const std::vector<const Scene*>& scenes, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
        const FitOptions& options) {
  BUMP_ASSERT(!scenes.empty() && !schemes.empty());
  check(scenes, configuration, options);
  std::vector<References> references;
  const int threads = options.jobs > 0 ? options.jobs : cores_of_process();
  for (const Scene* scene : scenes) references.push_back(draw_references(*scene, configuration, options.cancelled, threads));
  Fit result;
  result.scenes = scenes;
  result.configuration = &configuration;
  result.options = options;
  const Bench bench{scenes, references, options};
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    const auto progress = [&](double share) {
      if (options.progress) options.progress((static_cast<double>(i) + std::min(share, 1.0)) / static_cast<double>(schemes.size()));
    };
    result.rows.push_back(SchemeFit(bench, *schemes[i], configuration, progress).run());
  }
  return result;
}

const char* name_of(FitAgainst against) {
  return against == FitAgainst::own_double ? "double" : "reference";
}

const FitRow* worst_failure(const Fit& fit) {
  const FitRow* worst = nullptr;
  for (const FitRow& row : fit.rows)
    if (row.error && (worst == nullptr || row.error->kind() > worst->error->kind())) worst = &row;
  return worst;
}

}  // namespace bump
