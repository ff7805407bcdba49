// The search over structures, on schemes that are formulas.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "schemes/scheme.h"
#include "system/simulation.h"
#include "testbench/experiments/fit_structure.h"
#include "testbench/experiments/fit_variants.h"

using namespace bump;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Three choices: the first adds a width and takes noise away, the second is cheaper and changes no picture, the third makes the picture
/// better, but only together with the first.
struct MadeUp {
  double ceiling = 60, better_ceiling = 60;
  bool first_helps_alone = true;
  mutable std::set<std::pair<Structure, Widths>> seen;

  static FitVariant variant(const Structure& s) {
    FitVariant variant{{"a", "b"}, {{4, 12}, {4, 12}}};
    if (s[0] == 1) {
      variant.keys.push_back("c");
      variant.ranges.push_back({3, 9});
    }
    return variant;
  }
  double quality(const Structure& s, const Widths& w) const {
    const bool both = s[0] == 1 && s[2] == 1;
    double noise = std::pow(10.0, -(both ? better_ceiling : ceiling) / 10) + std::pow(4.0, -w[0]) + 0.3 * std::pow(4.0, -w[1]);
    if (s[0] == 1) noise += 0.1 * std::pow(4.0, -w[2]) - (first_helps_alone ? 0.25 * std::pow(4.0, -w[1]) : 0);
    return -10 * std::log10(noise);
  }
  static FitCost cost(const Structure& s, const Widths& w) {
    double sum = 100 * w[0] + (s[0] == 1 ? 20 : 90) * w[1] + (s[1] == 1 ? 50 : 200) + (s[2] == 1 ? 150 : 0);
    if (s[0] == 1) sum += 5 * w[2];
    return {sum};
  }

  VariantProblem problem(double target, int limit = 600) const {
    VariantProblem problem;
    problem.values = {2, 2, 2};
    problem.start = {0, 0, 0};
    problem.target = target;
    problem.limit = limit;
    problem.variant = [](const Structure& s) { return std::optional(variant(s)); };
    problem.cost = [](const Structure& s, const Widths& w) { return std::optional(cost(s, w)); };
    problem.measure = [this](const std::vector<std::pair<Structure, Widths>>& designs, double) {
      std::vector<double> qualities;
      for (const auto& [structure, widths] : designs) {
        seen.insert({structure, widths});
        qualities.push_back(quality(structure, widths));
      }
      return qualities;
    };
    problem.measured = [this] { return static_cast<int>(seen.size()); };
    return problem;
  }

  FitCost least(double target) const {
    FitCost best = {infinity};
    for (std::size_t bits = 0; bits < 8; ++bits) {
      const Structure s = {bits & 1, bits >> 1 & 1, bits >> 2 & 1};
      for (int a = 4; a <= 12; ++a)
        for (int b = 4; b <= 12; ++b)
          for (int c = 3; c <= (s[0] == 1 ? 9 : 3); ++c)
            if (quality(s, {a, b, c}) >= target && cost(s, {a, b, c}) < best) best = cost(s, {a, b, c});
    }
    return best;
  }
};

}  // namespace

TEST_CASE("the cheapest structure is found with its widths, and a choice that changes no picture is decided by its cost") {
  for (const double target : {28.0, 35.0, 41.0, 47.0}) {
    const MadeUp scheme;
    const VariantAnswer found = search_variants(scheme.problem(target));
    INFO(target);
    REQUIRE(found.answer.reached);
    CHECK(found.answer.complete);
    CHECK(found.structure == Structure{1, 1, 0});
    CHECK(found.variant.keys == MadeUp::variant(found.structure).keys);
    CHECK(found.answer.quality == scheme.quality(found.structure, found.answer.widths));
    CHECK(found.answer.quality >= target);
    CHECK(found.answer.cost[0] <= 1.02 * scheme.least(target)[0]);
    CHECK(found.answer.measured == static_cast<int>(scheme.seen.size()));
    CHECK(found.counts.possible == 8);
    CHECK(found.counts.same_picture > 0);
  }
}

TEST_CASE("a quality that only two choices together have is reached") {
  MadeUp scheme;
  scheme.ceiling = 30;
  scheme.first_helps_alone = false;
  const VariantAnswer found = search_variants(scheme.problem(40));
  REQUIRE(found.answer.reached);
  CHECK(found.structure[0] == 1);
  CHECK(found.structure[2] == 1);
}

TEST_CASE("where no structure reaches the quality, all combinations but those of the same picture were measured, and the best is given") {
  MadeUp scheme;
  scheme.ceiling = 30;
  scheme.better_ceiling = 34;
  scheme.first_helps_alone = false;
  const VariantAnswer found = search_variants(scheme.problem(50));
  CHECK_FALSE(found.answer.reached);
  CHECK(found.answer.quality == Approx(34).margin(0.5));
  CHECK(found.structure[0] == 1);
  CHECK(found.structure[2] == 1);
  CHECK(found.counts.all_tried);
  std::set<std::pair<std::size_t, std::size_t>> tried;
  for (const auto& [structure, widths] : scheme.seen) tried.insert({structure[0], structure[2]});
  CHECK(tried.size() == 4);
}

TEST_CASE("the limit holds for all structures together") {
  for (const int limit : {1, 3, 9, 30, 60}) {
    const MadeUp scheme;
    const VariantAnswer found = search_variants(scheme.problem(41, limit));
    INFO(limit);
    CHECK(static_cast<int>(scheme.seen.size()) <= limit);
    CHECK(found.answer.quality > -infinity);
    if (limit < 30) CHECK_FALSE(found.answer.complete);
  }
}

TEST_CASE("the same is found every time") {
  const MadeUp one, other;
  const VariantAnswer first = search_variants(one.problem(41)), second = search_variants(other.problem(41));
  CHECK(first.structure == second.structure);
  CHECK(first.answer.widths == second.answer.widths);
  CHECK(one.seen == other.seen);
}

TEST_CASE("a scheme's choices are its words, flags and small numbers, but for what is set and what decides more than cost") {
  Configuration configuration{all_parameters()};
  configuration.set_text("peercy1997.transform", "vertex", Location("--set"));
  const FitStructure peercy = fit_structure(find_scheme("peercy1997"), configuration);
  REQUIRE(peercy.choices.size() == 1);
  CHECK(peercy.choices[0].key == "peercy1997.normaliser");
  CHECK(peercy.set == std::vector<std::string>{"peercy1997.transform"});
  CHECK(peercy.kept.size() == 2);
  for (const Scheme* scheme : all_schemes()) {
    const FitStructure structure = fit_structure(*scheme, configuration);
    for (const FitChoice& choice : structure.choices) {
      INFO(choice.key);
      CHECK(choice.key.rfind(scheme->page().id + ".", 0) == 0);
      CHECK(choice.values.size() >= 2);
      CHECK(choice.values.size() <= 8);
      CHECK(choice.values[choice.given] == configuration.entries().at(choice.key).value);
    }
    for (const FitStructure::Kept& kept : structure.kept) CHECK_FALSE(kept.reason.empty());
    // What is given changes nothing, and every value can be taken.
    CHECK(with_structure(configuration, structure.choices, structure.given()).entries().size() == configuration.entries().size());
    Structure last;
    for (const FitChoice& choice : structure.choices) last.push_back(choice.values.size() - 1);
    const Configuration taken = with_structure(configuration, structure.choices, last);
    for (const FitChoice& choice : structure.choices) CHECK(taken.entries().at(choice.key).value == choice.values.back());
  }
}
