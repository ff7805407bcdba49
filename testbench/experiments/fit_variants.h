#pragma once
// The search over a scheme's structural variants, with the search for widths (fit_search.h) inside. Steps: every variant that differs from
// the given one in a single choice is measured at its widest; if none reaches the target, choices are flipped one after the other as long
// as the quality rises, and then all other combinations are tried, up to a number; the widths of the first variant that reaches are
// searched; then single flips of the best design so far are searched from its widths on, until none makes it cheaper. A flip is passed
// over where it cannot be cheaper: at its narrowest words, or, unless it promises a better picture, with every word two bits narrower than
// the best design's. A search: a local optimum, no proof. The order of measurements depends on nothing but the answers. No model of
// hardware.

#include <functional>
#include <string>
#include <vector>

#include "testbench/experiments/fit_search.h"
#include "testbench/experiments/fit_structure.h"

namespace bump {

/// What can be built with one structure.
struct FitVariant {
  std::vector<std::string> keys;  ///< of its widths, in order
  std::vector<WidthRange> ranges;
};

struct VariantProblem {
  std::vector<std::size_t> values;  ///< how many each choice has
  Structure start;                  ///< must be possible
  double target = 0;                ///< dB
  /// Nothing for choices that contradict one another, or make the same design as other ones that were asked for before. Asked once each.
  std::function<std::optional<FitVariant>(const Structure&)> variant;
  /// As FitProblem::cost.
  std::function<std::optional<FitCost>(const Structure&, const Widths&)> cost;
  /// As FitProblem::measure, but designs may have been asked for before, which costs nothing.
  std::function<std::vector<double>(const std::vector<std::pair<Structure, Widths>>&, double floor)> measure;
  std::function<int()> measured;  ///< designs until now
  int limit = 600;                ///< designs measured at most, at least 1
};

/// What became of the variants that were looked at; each is in one of these numbers.
struct VariantCounts {
  int possible = 1;       ///< combinations of choices; contradictions among them, if they were not all looked at
  int fitted = 0;         ///< a search of their widths was begun
  int falls_short = 0;    ///< measured at the widest, where they do not reach the target
  int same_picture = 0;   ///< measured at the widest, where they draw what another one draws, and cost no less
  int costlier = 0;       ///< passed over, as they cannot be cheaper
  bool all_tried = true;  ///< where none reaches: false if there were too many combinations to try them all
  int contradictory = 0;  ///< or the same design as another

  int measured() const { return fitted + falls_short + same_picture; }
};

struct VariantAnswer {
  Structure structure;
  FitVariant variant;
  FitAnswer answer;
  VariantCounts counts;
};

VariantAnswer search_variants(const VariantProblem& problem);

}  // namespace bump
