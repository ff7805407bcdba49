// The search for widths, on qualities that are formulas: the optimum can be had by trying everything.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>

#include "testbench/experiments/fit_noise.h"
#include "testbench/experiments/fit_search.h"

using namespace bump;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A datapath made up: every width adds noise, some are tables whose size doubles with a bit, the others operators.
struct MadeUp {
  std::vector<WidthRange> ranges;
  std::vector<double> noise, price;
  std::vector<bool> is_table;
  double ceiling = 0;   ///< noise that no width removes
  double coupling = 0;  ///< of neighbouring widths: the noise of both together beyond the sum
  double ripple = 0;    ///< dB, up and down, for no reason

  double quality(const Widths& widths) const {
    double sum = ceiling;
    std::uint64_t mixed = 99;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      sum += noise[i] * std::pow(4.0, -widths[i]);
      if (i > 0) sum += coupling * std::sqrt(noise[i] * noise[i - 1]) * std::pow(2.0, -widths[i] - widths[i - 1]);
      mixed = (mixed ^ static_cast<std::uint64_t>(widths[i])) * 0x9E3779B97F4A7C15U;
      mixed ^= mixed >> 29;
    }
    const double wave = static_cast<double>(mixed >> 40) / static_cast<double>(1 << 24) * 2 - 1;
    return -10 * std::log10(sum) + ripple * wave;
  }
  FitCost cost(const Widths& widths) const {
    double sum = 0, bits = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      sum += is_table[i] ? price[i] * std::ldexp(1.0, widths[i]) : 40 * price[i] * widths[i];
      bits += widths[i];
    }
    return {sum, bits};
  }
};

MadeUp made_up(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  const auto from_to = [&](int low, int high) { return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)); };
  MadeUp system;
  for (std::size_t i = 0; i < count; ++i) {
    const int low = from_to(4, 6);
    system.ranges.push_back({low, low + from_to(5, 7)});
    system.noise.push_back(0.01 * from_to(1, 100));
    system.price.push_back(from_to(1, 20));
    system.is_table.push_back(from_to(0, 1) == 1);
  }
  return system;
}

std::vector<Widths> all_of(const MadeUp& system) {
  std::vector<Widths> all = {{}};
  for (const WidthRange& range : system.ranges) {
    std::vector<Widths> longer;
    for (const Widths& begun : all)
      for (int width = range.low; width <= range.high; ++width) {
        longer.push_back(begun);
        longer.back().push_back(width);
      }
    all = longer;
  }
  return all;
}

/// Empty if none reaches the target.
FitCost least_cost(const MadeUp& system, double target) {
  FitCost least;
  for (const Widths& widths : all_of(system))
    if (system.quality(widths) >= target && (least.empty() || system.cost(widths) < least)) least = system.cost(widths);
  return least;
}

FitProblem problem_of(const MadeUp& system, double target) {
  FitProblem problem;
  problem.ranges = system.ranges;
  problem.target = target;
  problem.limit = 600;
  problem.cost = [&system](const Widths& widths) { return system.cost(widths); };
  problem.measure = [&system](const std::vector<Widths>& designs, double) {
    std::vector<double> qualities;
    for (const Widths& widths : designs) qualities.push_back(system.quality(widths));
    return qualities;
  };
  return problem;
}

}  // namespace

TEST_CASE("where quality grows with every width, the cheapest of all designs is found") {
  int designs = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const MadeUp system = made_up(seed, 2 + seed % 4);
    const double target = 40 + seed % 12;
    const FitCost least = least_cost(system, target);
    const FitAnswer answer = search_widths(problem_of(system, target));
    INFO("seed " << seed);
    REQUIRE(answer.reached == !least.empty());
    CHECK(answer.complete);
    designs += answer.measured;
    if (!answer.reached) continue;
    CHECK(answer.quality == system.quality(answer.widths));
    CHECK(answer.quality >= target);
    CHECK(answer.cost == system.cost(answer.widths));
    CHECK(answer.cost == least);
  }
  CHECK(designs / 40 < 120);  // of up to 32,768
}

TEST_CASE("where roundings help and disturb one another, the design found costs hardly more than the cheapest") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    MadeUp system = made_up(seed, 3 + seed % 3);
    system.coupling = seed % 3 == 0 ? 0.0 : seed % 3 == 1 ? 0.6 : -0.6;
    system.ripple = 0.4;
    const FitCost least = least_cost(system, 46);
    const FitAnswer answer = search_widths(problem_of(system, 46));
    INFO("seed " << seed);
    REQUIRE(answer.reached == !least.empty());
    if (!answer.reached) continue;
    CHECK(system.quality(answer.widths) >= 46);
    CHECK(answer.cost[0] <= 1.03 * least[0]);
  }
}

TEST_CASE("no design is measured twice, and none that contradicts itself") {
  const MadeUp system = made_up(7, 4);
  FitProblem problem = problem_of(system, 44);
  const auto contradicts = [](const Widths& widths) { return widths[0] < widths[1] - 1; };
  problem.cost = [&](const Widths& widths) { return contradicts(widths) ? std::nullopt : std::optional<FitCost>(system.cost(widths)); };
  std::set<Widths> seen;
  const auto plain = problem.measure;
  problem.measure = [&](const std::vector<Widths>& designs, double floor) {
    for (const Widths& widths : designs) {
      CHECK(seen.insert(widths).second);
      CHECK_FALSE(contradicts(widths));
      for (std::size_t i = 0; i < widths.size(); ++i) CHECK((widths[i] >= system.ranges[i].low && widths[i] <= system.ranges[i].high));
    }
    return plain(designs, floor);
  };
  const FitAnswer answer = search_widths(problem);
  CHECK(answer.reached);
  CHECK(answer.measured == static_cast<int>(seen.size()));
  CHECK_FALSE(contradicts(answer.widths));
}

TEST_CASE("a quality that no width reaches is not reached, and the best is told") {
  MadeUp system = made_up(3, 4);
  system.ceiling = 1e-3;  // 30 dB
  FitAnswer answer = search_widths(problem_of(system, 48));
  CHECK_FALSE(answer.reached);
  CHECK(answer.complete);
  CHECK(answer.measured < 20);
  double best = -infinity;
  for (const Widths& widths : all_of(system)) best = std::max(best, system.quality(widths));
  CHECK(answer.quality == best);  // the widest, without ripple
  CHECK(answer.quality == system.quality(answer.widths));

  // Just above the ceiling more is tried.
  system.ripple = 0.5;
  best = -infinity;
  for (const Widths& widths : all_of(system)) best = std::max(best, system.quality(widths));
  answer = search_widths(problem_of(system, best - 0.1));
  CHECK(answer.quality > 30);
}

TEST_CASE("the widest design need not be the best") {
  const MadeUp system = made_up(11, 3);
  FitProblem problem = problem_of(system, 45);
  const int spoiling = system.ranges[0].high;
  problem.measure = [&](const std::vector<Widths>& designs, double) {
    std::vector<double> qualities;
    for (const Widths& widths : designs) qualities.push_back(widths[0] == spoiling ? 42 : system.quality(widths));
    return qualities;
  };
  const FitAnswer answer = search_widths(problem);
  CHECK(answer.reached);
  CHECK(answer.widths[0] < spoiling);
}

TEST_CASE("the limit ends a search with the best that it has, and designs that fail are passed over") {
  const MadeUp system = made_up(5, 5);
  for (const int limit : {1, 2, 10, 25}) {
    FitProblem problem = problem_of(system, 44);
    problem.limit = limit;
    int asked = 0;
    const auto plain = problem.measure;
    problem.measure = [&](const std::vector<Widths>& designs, double floor) {
      asked += static_cast<int>(designs.size());
      return plain(designs, floor);
    };
    const FitAnswer answer = search_widths(problem);
    INFO(limit);
    CHECK(asked == limit);
    CHECK(answer.measured == limit);
    CHECK_FALSE(answer.complete);
    CHECK(answer.reached);  // the widest is the first
    CHECK(system.quality(answer.widths) >= 44);
  }
  FitProblem broken = problem_of(system, 44);
  broken.measure = [](const std::vector<Widths>& designs, double) {
    return std::vector<double>(designs.size(), std::numeric_limits<double>::quiet_NaN());
  };
  const FitAnswer none = search_widths(broken);
  CHECK_FALSE(none.reached);
  CHECK(none.quality == -infinity);
  CHECK(none.cost.empty());
}

TEST_CASE("a design without widths is measured as it is") {
  FitProblem problem;
  problem.target = 30;
  problem.cost = [](const Widths&) { return FitCost{1}; };
  problem.measure = [](const std::vector<Widths>& designs, double) { return std::vector<double>(designs.size(), 31.0); };
  CHECK(search_widths(problem).reached);
  problem.target = 32;
  const FitAnswer answer = search_widths(problem);
  CHECK_FALSE(answer.reached);
  CHECK(answer.quality == 31);
  CHECK(answer.measured == 1);
}

TEST_CASE("noises that were measured alone add up") {
  NoiseModel noise({{4, 8}, {6, 9}}, {8, 9}, 60);
  CHECK(noise.quality({8, 9}) == Approx(60));
  CHECK(noise.quality({7, 9}) == -infinity);  // never measured
  noise.set(0, 7, 50);
  noise.set(0, 6, 44);
  noise.set(1, 8, 50);
  CHECK(noise.quality({7, 9}) == Approx(50));
  CHECK(noise.quality({7, 8}) == Approx(-10 * std::log10(1.9e-5)));
  CHECK(noise.narrowest(49) == Widths{7, 8});
  CHECK(noise.narrowest(43) == Widths{6, 8});
  CHECK(noise.narrowest(70) == Widths{8, 9});
  // What was measured of a design corrects what is said of its neighbours.
  CHECK(noise.quality({7, 8}, {7, 8}, 46) == Approx(46));
  CHECK(noise.quality({7, 9}, {7, 8}, 46) < noise.quality({7, 9}));
}

TEST_CASE("what is known of a width fades by 6 dB a bit towards the base") {
  NoiseModel noise({{4, 8}}, {8}, 90);
  noise.set(0, 5, 40);
  noise.fade(0, 5);
  CHECK(noise.quality({5}) == Approx(40));
  CHECK(noise.quality({6}) == Approx(46).margin(0.1));
  CHECK(noise.quality({7}) == Approx(52).margin(0.1));
  CHECK(noise.quality({8}) == Approx(90));
}

TEST_CASE("qualities need not be exact below the floor that a search names") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const MadeUp system = made_up(seed, 2 + seed % 4);
    const double target = 40 + seed % 12;
    FitProblem vague = problem_of(system, target);
    vague.measure = [&system](const std::vector<Widths>& designs, double floor) {
      std::vector<double> qualities;
      for (const Widths& widths : designs) {
        const double quality = system.quality(widths);
        qualities.push_back(quality < floor ? std::max(quality, floor - 0.001) : quality);
      }
      return qualities;
    };
    const FitAnswer exact = search_widths(problem_of(system, target)), answer = search_widths(vague);
    INFO("seed " << seed);
    CHECK(answer.reached == exact.reached);
    if (!exact.reached) continue;
    CHECK(system.quality(answer.widths) >= target);
    CHECK(answer.quality == system.quality(answer.widths));
    CHECK(answer.cost == exact.cost);
  }
}

TEST_CASE(
    "near the answer of a design that is alike, a search takes fewer measurements, and finds nothing that costs more than its bound") {
  int near_measured = 0, far_measured = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    MadeUp system = made_up(seed, 5);
    const FitAnswer far = search_widths(problem_of(system, 44));
    if (!far.reached) continue;
    for (double& noise : system.noise) noise *= 1.3;  // the other design
    FitProblem problem = problem_of(system, 44);
    for (const int width : far.widths) problem.near.push_back(width);
    problem.near[1] = std::nullopt;
    const FitAnswer near = search_widths(problem), alone = search_widths(problem_of(system, 44));
    INFO("seed " << seed);
    REQUIRE(near.reached);
    CHECK(system.quality(near.widths) >= 44);
    CHECK(near.cost[0] <= 1.25 * alone.cost[0]);
    near_measured += near.measured;
    far_measured += alone.measured;
    problem.bound = {alone.cost[0] / 4};  // out of reach: given up early
    CHECK(search_widths(problem).measured <= near.measured);
  }
  CHECK(near_measured < far_measured);
}
