#include "testbench/experiments/fit_variants.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t together = 8;             ///< variants measured at a time where the answer to one may save the others
constexpr std::size_t most_combinations = 160;  ///< tried where no single choice helps
constexpr int narrower_at_most = 2;             ///< bits that every width of a variant may be below the best design's
constexpr double better_picture = 3;            ///< dB by which a variant's ceiling has to be higher for narrower words than that
constexpr double least_gain = 0.02;             ///< dB
constexpr int limit_of_a_flip = 70;             ///< designs measured at most for the widths of one flip
constexpr std::size_t patience_of_a_flip = 24;

class VariantSearch {
 public:
  explicit VariantSearch(const VariantProblem& problem) : problem_(problem) {
    for (const std::size_t values : problem.values)
      counts_.possible = static_cast<int>(std::min<std::size_t>(1'000'000, static_cast<std::size_t>(counts_.possible) * values));
  }

  VariantAnswer run() {
    VariantAnswer result;
    Structure from = problem_.start;
    BUMP_ASSERT(variant(from) != nullptr);
    measure_ceilings(flips(from), -infinity);
    if (!reaches(from)) from = structure_that_reaches(from);
    best_ = from;
    state(from) = State::fitted;
    answer_ = fit_widths(from, {});
    if (answer_.reached) improve();
    if (best_ != from) polish();
    result.structure = best_;
    result.variant = *variant(best_);
    result.answer = answer_;
    result.answer.complete = complete_;
    result.answer.measured = problem_.measured();
    result.counts = counts();
    return result;
  }

 private:
  enum class State { unknown, contradictory, measured, fitted, same_picture, costlier };
  struct Known {
    std::optional<FitVariant> variant;
    std::optional<double> ceiling;  ///< dB, of the widest
    State state = State::unknown;
  };

  // ---- what is known

  Known& known(const Structure& structure) {
    const auto [place, added] = known_.try_emplace(structure);
    if (added) {
      place->second.variant = problem_.variant(structure);
      if (!place->second.variant) place->second.state = State::contradictory;
    }
    return place->second;
  }
  const FitVariant* variant(const Structure& structure) {
    const Known& one = known(structure);
    return one.variant ? &*one.variant : nullptr;
  }
  State& state(const Structure& structure) { return known(structure).state; }
  double ceiling(const Structure& structure) {
    const Known& one = known(structure);
    return one.ceiling.value_or(-infinity);
  }
  bool reaches(const Structure& structure) { return ceiling(structure) >= problem_.target; }

  int left() const { return std::max(0, problem_.limit - problem_.measured()); }

  Widths widest(const Structure& structure) {
    Widths widths;
    for (const WidthRange& range : variant(structure)->ranges) widths.push_back(range.high);
    return widths;
  }

  /// Possible ones that differ from it in one choice, and itself.
  std::vector<Structure> flips(const Structure& from) {
    std::vector<Structure> found = {from};
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t value = 0; value < problem_.values[i]; ++value) {
        Structure next = from;
        next[i] = value;
        if (next != from && variant(next) != nullptr) found.push_back(next);
      }
    return found;
  }

  void measure_ceilings(const std::vector<Structure>& structures, double floor) {
    std::vector<std::pair<Structure, Widths>> asked;
    for (const Structure& structure : structures) {
      if (known(structure).ceiling || variant(structure) == nullptr) continue;
      if (static_cast<int>(asked.size()) >= left()) {
        complete_ = false;
        break;
      }
      asked.emplace_back(structure, widest(structure));
    }
    if (asked.empty()) return;
    const std::vector<double> qualities = problem_.measure(asked, floor);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      Known& one = known(asked[i].first);
      one.ceiling = qualities[i];
      if (one.state == State::unknown) one.state = State::measured;
    }
  }

  // ---- a structure that reaches the target

  /// Choices that reach with the widest words, cheapest first by those; else the best picture.
  Structure structure_that_reaches(Structure from) {
    for (;;) {
      const std::vector<Structure> near = flips(from);
      if (const std::optional<Structure> found = cheapest_that_reaches(near)) return *found;
      const Structure best = best_picture(near);
      if (ceiling(best) < ceiling(from) + least_gain || !complete_) break;
      from = best;
      measure_ceilings(flips(from), -infinity);
    }
    if (const std::optional<Structure> found = try_combinations(from)) return *found;
    std::vector<Structure> all;
    for (const auto& [structure, one] : known_)
      if (one.ceiling) all.push_back(structure);
    const Structure best = best_picture(all);
    return ceiling(best) >= ceiling(problem_.start) + least_gain ? best : problem_.start;
  }

  std::optional<Structure> cheapest_that_reaches(const std::vector<Structure>& structures) {
    std::optional<Structure> found;
    FitCost least;
    for (const Structure& structure : structures) {
      if (!reaches(structure)) continue;
      const std::optional<FitCost> cost = problem_.cost(structure, widest(structure));
      if (!cost || (found && !(*cost < least))) continue;
      found = structure;
      least = *cost;
    }
    return found;
  }

  Structure best_picture(const std::vector<Structure>& structures) {
    Structure best = structures.front();
    for (const Structure& structure : structures)
      if (ceiling(structure) > ceiling(best)) best = structure;
    return best;
  }

  /// All others, in order; those last that differ by values that alone changed no picture.
  std::optional<Structure> try_combinations(const Structure& from) {
    std::vector<Structure> likely, others;
    Structure next(from.size(), 0);
    for (bool more = true; more;) {
      bool is_likely = true;
      for (std::size_t i = 0; i < from.size(); ++i) is_likely = is_likely && !changes_no_picture(from, i, next[i]);
      (is_likely ? likely : others).push_back(next);
      counts_.all_tried = likely.size() + others.size() <= most_combinations;
      more = counts_.all_tried;
      std::size_t place = 0;
      while (place < next.size() && ++next[place] == problem_.values[place]) next[place++] = 0;
      more = more && place < next.size();
    }
    likely.insert(likely.end(), others.begin(), others.end());
    for (std::size_t begin = 0; begin < likely.size() && complete_; begin += together) {
      const std::vector<Structure> batch(likely.begin() + static_cast<std::ptrdiff_t>(begin),
                                         likely.begin() + static_cast<std::ptrdiff_t>(std::min(likely.size(), begin + together)));
      measure_ceilings(batch, -infinity);
      if (const std::optional<Structure> found = cheapest_that_reaches(batch)) return found;
    }
    counts_.all_tried = counts_.all_tried && complete_;
    return std::nullopt;
  }

  bool changes_no_picture(const Structure& from, std::size_t choice, std::size_t value) {
    if (value == from[choice]) return false;
    Structure next = from;
    next[choice] = value;
    return variant(next) != nullptr && known(next).ceiling && ceiling(next) == ceiling(from);
  }

  // ---- cheaper structures

  FitAnswer fit_widths(const Structure& structure, const std::vector<std::optional<int>>& near) {
    if (left() == 0 && answer_.reached) {
      complete_ = false;
      return {};
    }
    FitProblem problem;
    problem.ranges = variant(structure)->ranges;
    problem.target = problem_.target;
    problem.cost = [&](const Widths& widths) { return problem_.cost(structure, widths); };
    problem.measure = [&](const std::vector<Widths>& designs, double floor) {
      std::vector<std::pair<Structure, Widths>> asked;
      for (const Widths& widths : designs) asked.emplace_back(structure, widths);
      return problem_.measure(asked, floor);
    };
    problem.limit = std::max(1, left());
    if (!near.empty()) {
      problem.limit = std::min(problem.limit, limit_of_a_flip);
      problem.near = near;
      problem.bound = answer_.cost;
      problem.patience = patience_of_a_flip;
    }
    FitAnswer answer = search_widths(problem);
    if (!answer.complete && left() == 0) complete_ = false;
    return answer;
  }

  void improve() {
    for (bool better = true; better && complete_;) {
      better = false;
      const std::vector<Structure> near = flips(best_);
      for (std::size_t i = 1; i < near.size() && !better && complete_; ++i) better = is_better(near[i]);
    }
  }

  /// The best design was found by a shorter search than the first.
  void polish() {
    const FitAnswer answer = fit_widths(best_, {});
    if (answer.reached && answer.cost < answer_.cost) answer_ = answer;
  }

  /// Of the best design, for the widths that the structure has, too.
  std::vector<std::optional<int>> widths_near(const Structure& structure) {
    const FitVariant &theirs = *variant(structure), &own = *variant(best_);
    std::vector<std::optional<int>> near;
    for (const std::string& key : theirs.keys) {
      const auto place = std::find(own.keys.begin(), own.keys.end(), key);
      near.push_back(place == own.keys.end() ? std::nullopt
                                             : std::optional(answer_.widths[static_cast<std::size_t>(place - own.keys.begin())]));
    }
    return near;
  }

  /// With words so much narrower than the best design's; new ones at their narrowest.
  bool may_be_cheaper(const Structure& structure, int narrower) {
    const FitVariant& theirs = *variant(structure);
    const std::vector<std::optional<int>> near = widths_near(structure);
    Widths widths;
    for (std::size_t i = 0; i < near.size(); ++i)
      widths.push_back(near[i] ? std::clamp(*near[i] - narrower, theirs.ranges[i].low, theirs.ranges[i].high) : theirs.ranges[i].low);
    const std::optional<FitCost> cost = problem_.cost(structure, widths);
    return !cost || *cost < answer_.cost;
  }

  bool is_better(const Structure& structure) {
    Known& one = known(structure);
    if (one.state != State::unknown && one.state != State::measured) return false;
    if (one.ceiling && !reaches(structure)) return false;
    constexpr int narrowest = 100;
    if (!may_be_cheaper(structure, narrowest)) {
      one.state = State::costlier;
      return false;
    }
    measure_ceilings({structure}, problem_.target);
    if (!one.ceiling || !reaches(structure)) return false;
    const bool same_picture = *one.ceiling == ceiling(best_) && variant(structure)->keys == variant(best_)->keys;
    if (same_picture && keeps_its_picture(structure)) return take_if_cheaper(structure);
    if (*one.ceiling < ceiling(best_) + better_picture && !may_be_cheaper(structure, narrower_at_most)) {
      one.state = State::costlier;
      return false;
    }
    one.state = State::fitted;
    const FitAnswer answer = fit_widths(structure, widths_near(structure));
    if (!answer.reached || !(answer.cost < answer_.cost)) return false;
    best_ = structure;
    answer_ = answer;
    return true;
  }

  double quality_at_best_widths(const Structure& structure) {
    if (left() == 0) {
      complete_ = false;
      return -infinity;
    }
    return problem_.measure({{structure, answer_.widths}}, problem_.target).front();
  }
  bool keeps_its_picture(const Structure& structure) { return quality_at_best_widths(structure) == answer_.quality; }

  bool take_if_cheaper(const Structure& structure) {
    const std::optional<FitCost> cost = problem_.cost(structure, answer_.widths);
    state(structure) = State::same_picture;
    if (!cost || !(*cost < answer_.cost)) return false;
    state(best_) = State::same_picture;
    state(structure) = State::fitted;
    best_ = structure;
    answer_.cost = *cost;
    return true;
  }

  VariantCounts counts() {
    VariantCounts counts = counts_;
    for (const auto& [structure, one] : known_) switch (one.state) {
        case State::contradictory:
          ++counts.contradictory;
          break;
        case State::fitted:
          ++counts.fitted;
          break;
        case State::same_picture:
          ++counts.same_picture;
          break;
        case State::costlier:
          ++counts.costlier;
          break;
        case State::measured:
          if (one.ceiling && *one.ceiling < problem_.target) ++counts.falls_short;
          break;
        case State::unknown:
          break;
      }
    return counts;
  }

  const VariantProblem& problem_;
  std::map<Structure, Known> known_;
  VariantCounts counts_;
  Structure best_;
  FitAnswer answer_;
  bool complete_ = true;
};

}  // namespace

VariantAnswer search_variants(const VariantProblem& problem) {
  BUMP_ASSERT(problem.limit >= 1 && problem.values.size() == problem.start.size());
  return VariantSearch(problem).run();
}

}  // namespace bump
