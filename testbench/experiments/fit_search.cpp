#include "testbench/experiments/fit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "datapath/invariant.h"
#include "testbench/experiments/fit_noise.h"

namespace bump {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t together = 8;        ///< designs measured at a time where the answer to one may save the others
constexpr double scanned_below = 3;        ///< dB below the target down to which a width is tried alone
constexpr double worth_climbing = 6;       ///< dB below the target from which better neighbours are looked for
constexpr double least_gain = 0.02;        ///< dB
constexpr double hopeful = 1;              ///< dB below the target that a design may be predicted to be, and still be measured
constexpr double surely_worse = 2;         ///< dB below the target: designs that are narrower everywhere are not measured
constexpr double worth_descending = 1.15;  ///< times the bound that a design near a known one may cost to be made cheaper
constexpr int most_spare_bits = 4;         ///< beyond what noises that add up just allow to hope for
constexpr int longest_climb = 3;           ///< bits that all widths near a known design may be raised by
constexpr std::size_t no_width = std::numeric_limits<std::size_t>::max();
constexpr int longest_step = 3;  ///< bits that one width is lowered by at once

struct Measured {
  double quality = 0;  ///< dB
  double floor = 0;    ///< below which it may be less than that
  bool is_known(double at_floor) const { return quality >= floor || quality < at_floor; }
};

/// The limit ends the search from wherever it is.
struct LimitReached {};

class Search {
 public:
  explicit Search(const FitProblem& problem) : problem_(problem), count_(problem.ranges.size()) {
    for (const WidthRange& range : problem.ranges) {
      BUMP_ASSERT(range.low <= range.high);
      widest_.push_back(range.high);
    }
  }

  FitAnswer run() {
    bool complete = true;
    try {
      search();
    } catch (const LimitReached&) {
      complete = false;
    }
    FitAnswer answer;
    answer.complete = complete;
    answer.measured = static_cast<int>(measured_.size());
    answer.reached = reached_.has_value();
    answer.widths = reached_ ? *reached_ : best_ ? *best_ : widest_;
    answer.quality = reached_ || best_ ? measured_.at(answer.widths).quality : -infinity;
    if (answer.quality > -infinity) answer.cost = *cost_of(answer.widths);
    return answer;
  }

 private:
  void search() {
    if (!problem_.near.empty()) return search_near();
    Widths base = widest_;
    if (quality_of(base) < problem_.target) base = climb();
    if (!reached_) return;
    const Widths uniform = together_at(narrowest_together());
    if (nothing_is_narrower()) return;
    NoiseModel noise(problem_.ranges, base, quality_of(base));
    scan(base, uniform, noise);
    start_from(noise, base);
    descend(noise);
    while (try_cheaper(rebalanced(noise, base)) || try_cheaper(exchanged(), true)) descend(noise);
  }

  /// From one bit more than a design that is alike, with widths that it does not have as narrow as they may be together.
  void search_near() {
    std::optional<Widths> found;
    for (int raise = 1; raise <= longest_climb && !found; ++raise)
      if (const Widths wide = near_at(raise, steps()); reaches(wide)) found = near_at(raise, narrowest_new(raise));
    if (!found) return;
    const Widths base = *found;
    NoiseModel noise(problem_.ranges, base, quality_of(base));
    scan(base, base, noise);
    if (const auto& least = cost_of(noise.narrowest(problem_.target)); least && !is_useful(*least)) return;
    start_from(noise, base);
    if (is_within_reach(*cost_of(*reached_))) descend(noise);
  }
  /// Known widths raised, the others between the narrowest (0) and the widest (steps()).
  Widths near_at(int raise, int step) const {
    Widths widths = together_at(step);
    for (std::size_t i = 0; i < count_; ++i)
      if (problem_.near[i]) widths[i] = std::clamp(*problem_.near[i] + raise, problem_.ranges[i].low, problem_.ranges[i].high);
    return widths;
  }
  int narrowest_new(int raise) {
    int fails = -1, holds = steps();
    while (holds - fails > 1) {
      const int middle = (fails + holds) / 2;
      (near_at(raise, middle) == near_at(raise, holds) || reaches(near_at(raise, middle)) ? holds : fails) = middle;
    }
    return std::min(steps(), holds + 1);
  }
  bool is_within_reach(const FitCost& cost) const {
    return problem_.bound.empty() || cost.front() <= worth_descending * problem_.bound.front();
  }
  bool is_useful(const FitCost& cost) const { return problem_.bound.empty() || cost < problem_.bound; }

  // ---- what is known

  const std::optional<FitCost>& cost_of(const Widths& widths) {
    const auto known = costs_.find(widths);
    return known != costs_.end() ? known->second : costs_.emplace(widths, problem_.cost(widths)).first->second;
  }

  /// What is not known yet, or not as exactly; designs that contradict themselves fail without being measured.
  void measure(const std::vector<Widths>& asked, double floor) {
    std::vector<Widths> fresh;
    std::size_t added = 0;
    const std::size_t left =
        static_cast<std::size_t>(problem_.limit) - std::min(measured_.size(), static_cast<std::size_t>(problem_.limit));
    bool too_many = false;
    for (const Widths& widths : asked) {
      const auto known = measured_.find(widths);
      if (known != measured_.end() && known->second.is_known(floor)) continue;
      if (std::find(fresh.begin(), fresh.end(), widths) != fresh.end() || !cost_of(widths)) continue;
      if (known == measured_.end() && ++added > left) {
        too_many = true;
        break;
      }
      fresh.push_back(widths);
    }
    if (!fresh.empty()) {
      const std::vector<double> qualities = problem_.measure(fresh, floor);
      BUMP_ASSERT(qualities.size() == fresh.size());
      for (std::size_t i = 0; i < fresh.size(); ++i) note(fresh[i], std::isnan(qualities[i]) ? -infinity : qualities[i], floor);
    }
    if (too_many) throw LimitReached();
  }

  void note(const Widths& widths, double quality, double floor) {
    measured_[widths] = {quality, floor};
    if (quality > -infinity && (!best_ || is_better(widths, *best_))) best_ = widths;
    if (quality >= problem_.target && (!reached_ || *cost_of(widths) < *cost_of(*reached_))) reached_ = widths;
  }
  bool is_better(const Widths& one, const Widths& other) {
    const double of_one = measured_.at(one).quality, of_other = measured_.at(other).quality;
    return of_one != of_other ? of_one > of_other : *cost_of(one) < *cost_of(other);
  }

  double quality_of(const Widths& widths, double floor = -infinity) {
    measure({widths}, floor);
    const auto known = measured_.find(widths);
    return known != measured_.end() ? known->second.quality : -infinity;
  }
  bool reaches(const Widths& widths) { return quality_of(widths, problem_.target) >= problem_.target; }

  // ---- steps

  /// Between the narrowest (0) and the widest (steps()).
  Widths together_at(int step) const {
    Widths widths;
    for (const WidthRange& range : problem_.ranges)
      widths.push_back(range.low + (2 * (range.high - range.low) * step + steps()) / std::max(1, 2 * steps()));
    return widths;
  }
  int steps() const {
    int most = 0;
    for (const WidthRange& range : problem_.ranges) most = std::max(most, range.high - range.low);
    return most;
  }

  /// The widest design does not reach the target: another may, if rounding errors happen to cancel. Returns the best.
  Widths climb() {
    std::vector<Widths> line;
    for (int step = 0; step < steps(); ++step) line.push_back(together_at(step));
    measure(line, -infinity);
    while (best_ && !reached_ && measured_.at(*best_).quality >= problem_.target - worth_climbing) {
      const double before = measured_.at(*best_).quality;
      std::vector<Widths> neighbours;
      for (std::size_t i = 0; i < count_; ++i)
        for (const int change : {1, -1})
          if (const Widths next = changed(*best_, i, change); is_allowed(next)) neighbours.push_back(next);
      measure(neighbours, -infinity);
      if (measured_.at(*best_).quality < before + least_gain) break;
    }
    return reached_ ? *reached_ : best_ ? *best_ : widest_;
  }

  /// A step at which all together reach the target, and at the one below not.
  int narrowest_together() {
    int fails = -1, holds = steps();
    while (holds - fails > 1) {
      const int middle = (fails + holds) / 2;
      (reaches(together_at(middle)) ? holds : fails) = middle;
    }
    return holds;
  }

  /// The narrowest widths reach the target, and no bit more makes anything cheaper.
  bool nothing_is_narrower() {
    const Widths narrowest = together_at(0);
    if (!measured_.count(narrowest) || !(measured_.at(narrowest).quality >= problem_.target)) return false;
    for (std::size_t i = 0; i < count_; ++i) {
      const Widths wider = changed(narrowest, i, 1);
      if (is_allowed(wider) && cost_of(wider) && *cost_of(wider) < *cost_of(narrowest)) return false;
    }
    return true;
  }

  /// Every width alone from that in `from` down, the others as in `base`, side by side.
  void scan(const Widths& base, const Widths& from, NoiseModel& noise) {
    const double floor = problem_.target - scanned_below;
    std::vector<std::size_t> going;
    Widths value;
    for (std::size_t i = 0; i < count_; ++i) {
      value.push_back(std::min(from[i], base[i] - 1));
      if (value[i] >= problem_.ranges[i].low) going.push_back(i);
    }
    for (bool first = true; !going.empty(); first = false) {
      std::vector<Widths> asked;
      for (const std::size_t i : going) asked.push_back(changed(base, i, value[i] - base[i]));
      measure(asked, floor);
      std::vector<std::size_t> further;
      for (std::size_t k = 0; k < going.size(); ++k) {
        const std::size_t i = going[k];
        const double quality = quality_of(asked[k], floor);
        noise.set(i, value[i], quality);
        if (first) noise.fade(i, value[i]);
        if (quality >= floor && --value[i] >= problem_.ranges[i].low) further.push_back(i);
      }
      going = further;
    }
  }

  /// From the narrowest widths that hold alone, the most useful bits for their cost are added until the target is reached.
  void start_from(const NoiseModel& noise, const Widths& base) {
    Widths widths = noise.narrowest(problem_.target);
    while (noise.quality(widths) < problem_.target && add_bit(noise, base, widths)) {
    }
    for (;;) {
      std::vector<Widths> asked = {widths};
      while (asked.size() < together / 2 && add_bit(noise, base, widths)) asked.push_back(widths);
      measure(asked, problem_.target);
      if (std::any_of(asked.begin(), asked.end(), [&](const Widths& one) { return reaches(one); }) || !add_bit(noise, base, widths)) return;
    }
  }

  bool add_bit(const NoiseModel& noise, const Widths& base, Widths& widths, std::size_t but = no_width) {
    double most = -infinity;
    Widths chosen;
    for (std::size_t i = 0; i < count_; ++i) {
      if (widths[i] >= base[i] || i == but) continue;
      Widths next = changed(widths, i, 1);
      if (!cost_of(next)) continue;
      const double gain = noise.amount(widths) - noise.amount(next), price = std::max(weight(next) - weight(widths), 1e-12);
      const double worth = std::isnan(gain) ? 0 : gain / price;
      if (worth > most) {
        most = worth;
        chosen = std::move(next);
      }
    }
    if (chosen.empty()) return false;
    widths = chosen;
    return true;
  }

  /// A cost as one number, for ratios: what comes later weighs little.
  double weight(const Widths& widths) {
    const std::optional<FitCost>& cost = cost_of(widths);
    if (!cost) return infinity;
    const FitCost& whole = *cost_of(*reached_);
    double sum = 0, scale = 1;
    for (std::size_t i = 0; i < cost->size(); ++i, scale /= 1000) sum += scale * (*cost)[i] / std::max(1.0, std::abs(whole[i]));
    return sum;
  }

  struct Candidate {
    Widths widths;
    double shortfall = 0;  ///< predicted; 0 if the target is reached
  };

  void descend(const NoiseModel& noise) {
    while (try_cheaper(hopeful_neighbours(noise, *reached_))) {
    }
  }

  /// One width a bit narrower or wider than in the best design, and all others anew by the noises that add up: what exchanges of two
  /// widths do not find.
  std::vector<Candidate> rebalanced(const NoiseModel& noise, const Widths& base) {
    const Widths from = *reached_, least = noise.narrowest(problem_.target);
    const double quality = measured_.at(from).quality;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < count_; ++i)
      for (const int change : {-1, 1}) {
        Widths widths = least;
        widths[i] = from[i] + change;
        if (!is_allowed(widths)) continue;
        bool more = true;
        while (more && noise.quality(widths, from, quality) < problem_.target - hopeful) more = add_bit(noise, base, widths, i);
        for (int spare = 0; more && spare <= most_spare_bits; ++spare) {  // predictions are rough
          const std::optional<FitCost>& cost = cost_of(widths);
          if (cost && *cost < *cost_of(from)) candidates.push_back({widths, 0});
          more = add_bit(noise, base, widths, i);
        }
      }
    sort_by_cost(candidates);
    return candidates;
  }

  /// One width a bit narrower and another a bit wider than in the best design, whatever noises that add up promise.
  std::vector<Candidate> exchanged() {
    const Widths from = *reached_;
    std::vector<Candidate> candidates;
    for (std::size_t down = 0; down < count_; ++down)
      for (std::size_t up = 0; up < count_; ++up) {
        if (up == down) continue;
        const Widths widths = changed(changed(from, down, -1), up, 1);
        if (!is_allowed(widths)) continue;
        const std::optional<FitCost>& cost = cost_of(widths);
        if (cost && *cost < *cost_of(from)) candidates.push_back({widths, 0});
      }
    sort_by_cost(candidates);
    return candidates;
  }

  void sort_by_cost(std::vector<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      const FitCost &one = *cost_of(a.widths), &other = *cost_of(b.widths);
      return one != other ? one < other : a.widths < b.widths;
    });
  }

  /// True if one of them reaches the target and is cheaper.
  bool try_cheaper(const std::vector<Candidate>& candidates, bool whatever_is_known = false) {
    const FitCost before = *cost_of(*reached_);
    for (std::size_t begin = 0; begin < std::min(candidates.size(), problem_.patience); begin += together) {
      std::vector<Widths> asked;
      for (std::size_t i = begin; i < std::min(candidates.size(), begin + together); ++i)
        if (whatever_is_known || !is_hopeless(candidates[i].widths)) asked.push_back(candidates[i].widths);
      measure(asked, problem_.target);
      if (*cost_of(*reached_) < before) return true;
    }
    return false;
  }

  /// Narrower everywhere than one that is clearly not good enough.
  bool is_hopeless(const Widths& widths) const {
    for (const auto& [known, value] : measured_) {
      if (value.quality >= problem_.target - surely_worse) continue;
      bool covers = true;
      for (std::size_t i = 0; i < count_ && covers; ++i) covers = known[i] >= widths[i];
      if (covers) return true;
    }
    return false;
  }

  /// Cheaper neighbours that are not known yet: those predicted to reach the target by cost, then the others by what they lack.
  std::vector<Candidate> hopeful_neighbours(const NoiseModel& noise, const Widths& from) {
    const FitCost cost = *cost_of(from);
    const double quality = measured_.at(from).quality;
    std::vector<Candidate> candidates;
    for (const Widths& widths : neighbours(from)) {
      if (measured_.count(widths) > 0) continue;
      const double shortfall = std::max(0.0, problem_.target - noise.quality(widths, from, quality));
      if (!(shortfall <= hopeful)) continue;
      if (const std::optional<FitCost>& theirs = cost_of(widths); theirs && *theirs < cost) candidates.push_back({widths, shortfall});
    }
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
      if (a.shortfall != b.shortfall) return a.shortfall < b.shortfall;
      const FitCost &one = *cost_of(a.widths), &other = *cost_of(b.widths);
      return one != other ? one < other : a.widths < b.widths;
    });
    return candidates;
  }

  /// One width lowered by up to longest_step bits, or two by one; and one of the others as it is, or raised by one or two.
  std::set<Widths> neighbours(const Widths& from) const {
    std::vector<Widths> lowered;
    for (std::size_t i = 0; i < count_; ++i) {
      for (int step = 1; step <= longest_step; ++step) lowered.push_back(changed(from, i, -step));
      for (std::size_t j = i + 1; j < count_; ++j) lowered.push_back(changed(changed(from, i, -1), j, -1));
    }
    std::set<Widths> found;
    for (const Widths& widths : lowered) {
      if (!is_allowed(widths)) continue;
      found.insert(widths);
      for (std::size_t i = 0; i < count_; ++i)
        for (const int raise : {1, 2})
          if (const Widths next = changed(widths, i, raise); widths[i] == from[i] && is_allowed(next)) found.insert(next);
    }
    return found;
  }

  static Widths changed(Widths widths, std::size_t index, int change) {
    widths[index] += change;
    return widths;
  }
  bool is_allowed(const Widths& widths) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (widths[i] < problem_.ranges[i].low || widths[i] > problem_.ranges[i].high) return false;
    return true;
  }

  const FitProblem& problem_;
  std::size_t count_;
  Widths widest_;
  std::map<Widths, std::optional<FitCost>> costs_;
  std::map<Widths, Measured> measured_;
  std::optional<Widths> best_, reached_;
};

}  // namespace

FitAnswer search_widths(const FitProblem& problem) {
  BUMP_ASSERT(problem.limit >= 1);
  return Search(problem).run();
}

}  // namespace bump
