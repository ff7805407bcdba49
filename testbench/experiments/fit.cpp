#include "testbench/experiments/fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "datapath/invariant.h"
#include "testbench/experiments/fit_bench.h"
#include "testbench/experiments/fit_widths.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/reference/cores.h"

namespace bump {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One scheme.
class SchemeFit {
 public:
  SchemeFit(const FitScenes& scenes, const Scheme& scheme, const Configuration& configuration, std::function<void(double)> progress)
      : options_(scenes.options), scheme_(scheme), configuration_(configuration), bench_(scenes, scheme, std::move(progress)) {
    row_.page = &scheme.page();
  }

  FitRow run() {
    try {
      search();
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) throw;
      row_.error = error;
    }
    row_.measured = bench_.measured();
    row_.failed = bench_.failed();
    return std::move(row_);
  }

 private:
  void search() {
    read_structure();
    scheme_.design(configuration_, Material{});  // throws what is wrong with the settings
    VariantProblem problem;
    for (const FitChoice& choice : row_.choices) problem.values.push_back(choice.values.size());
    for (const FitChoice& choice : row_.choices) problem.start.push_back(choice.given);
    problem.target = options_.psnr_db;
    problem.limit = options_.limit;
    problem.variant = [this](const Structure& structure) { return variant(structure); };
    problem.cost = [this](const Structure& structure, const Widths& widths) {
      return bench_.cost(design(structure, widths), std::accumulate(widths.begin(), widths.end(), 0));
    };
    problem.measure = [this](const std::vector<std::pair<Structure, Widths>>& designs, double floor) { return measure(designs, floor); };
    problem.measured = [this] { return bench_.measured(); };
    take(search_variants(problem));
  }

  void read_structure() {
    FitStructure structure = fit_structure(scheme_, configuration_);
    row_.kept = std::move(structure.kept);
    row_.set = std::move(structure.set);
    if (options_.search_structure)
      row_.choices = std::move(structure.choices);
    else
      for (const FitChoice& choice : structure.choices) row_.left.push_back(choice.key);
  }

  std::optional<FitVariant> variant(const Structure& structure) {
    const Configuration configuration = with_structure(configuration_, row_.choices, structure);
    const bool given = structure == given_structure();
    try {
      const FitParameters parameters = fit_parameters(scheme_, configuration);
      if (!is_new(configuration, parameters) && !given) return std::nullopt;
      parameters_[structure] = parameters;
      return FitVariant{parameters.keys, parameters.ranges};
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input || given) throw;
      return std::nullopt;
    }
  }

  /// Whether no structure before made this design, told at the widest words. What they contradict may still be possible with others.
  bool is_new(const Configuration& configuration, const FitParameters& parameters) {
    Widths widest;
    for (const WidthRange& range : parameters.ranges) widest.push_back(range.high);
    try {
      const Design design = scheme_.design(with_widths(configuration, parameters.keys, widest), Material{});
      return signatures_.insert(design_signature(design)).second || design.map.bake;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      return true;
    }
  }

  Structure given_structure() const {
    Structure structure;
    for (const FitChoice& choice : row_.choices) structure.push_back(choice.given);
    return structure;
  }

  Configuration design(const Structure& structure, const Widths& widths) const {
    return with_widths(with_structure(configuration_, row_.choices, structure), parameters_.at(structure).keys, widths);
  }

  std::vector<double> measure(const std::vector<std::pair<Structure, Widths>>& designs, double floor) {
    std::vector<Configuration> configurations;
    for (const auto& [structure, widths] : designs) configurations.push_back(design(structure, widths));
    return bench_.worst(configurations, floor);
  }

  void take(const VariantAnswer& found) {
    const FitAnswer& answer = found.answer;
    BUMP_ASSERT(answer.quality > -infinity || bench_.first_error());
    if (answer.quality == -infinity) throw *bench_.first_error();
    const FitParameters& parameters = parameters_.at(found.structure);
    row_.structure = found.structure;
    row_.variants = found.counts;
    row_.keys = parameters.keys;
    row_.ranges = parameters.ranges;
    row_.idle = parameters.idle;
    row_.set.insert(row_.set.end(), parameters.set.begin(), parameters.set.end());
    std::sort(row_.set.begin(), row_.set.end());
    row_.widths = answer.widths;
    row_.reached = answer.reached;
    row_.complete = answer.complete;
    const Configuration best = design(found.structure, answer.widths);
    row_.size = bench_.size(best, std::accumulate(answer.widths.begin(), answer.widths.end(), 0));
    find_limits(found.structure);
    confirm(best, answer.quality);
  }

  /// Widths that are at their least, where a bit more costs more: there, less might cost less.
  void find_limits(const Structure& structure) {
    for (std::size_t i = 0; i < row_.widths.size(); ++i) {
      if (row_.widths[i] > row_.ranges[i].low || row_.ranges[i].low == row_.ranges[i].high) continue;
      Widths wider = row_.widths;
      ++wider[i];
      const Configuration configuration = design(structure, wider);
      const std::optional<FitCost> cost = bench_.cost(configuration, 0);
      const bool costs = cost && cost->front() > cost_of(row_.size, options_.cost).front();
      (costs ? row_.costly_limits : row_.idle_limits).push_back(row_.keys[i]);
    }
  }

  void confirm(const Configuration& best, double quality) {
    row_.qualities = bench_.in_full(best);
    const double again = row_.worst(options_.against == FitAgainst::own_double ? &FitQuality::to_double : &FitQuality::to_reference);
    if (again != quality)
      throw Error(ErrorKind::self_check, {fmt::format("self-check failed: a run of the design found gives {:.6f} dB", again),
                                          {},
                                          fmt::format("{:.6f} dB was measured while searching", quality),
                                          "report this with the command that led to it"});
  }

  const FitOptions& options_;
  const Scheme& scheme_;
  const Configuration& configuration_;
  FitBench bench_;
  std::map<Structure, FitParameters> parameters_;
  std::set<std::string> signatures_;
  FitRow row_;
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

std::vector<std::pair<std::string, std::string>> FitRow::taken() const {
  std::vector<std::pair<std::string, std::string>> settings;
  for (std::size_t i = 0; i < structure.size(); ++i)
    if (structure[i] != choices[i].given) settings.emplace_back(choices[i].key, to_string(choices[i].values[structure[i]]));
  return settings;
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
  const FitScenes bench{scenes, references, options};
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
