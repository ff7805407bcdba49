#pragma once
// The search for the cheapest widths that reach a quality, where a quality takes a simulation and a cost does not. Quality grows with
// widths only roughly, so every answer is measured, and only designs are skipped that are narrower everywhere than one 2 dB short. Steps:
// the widest design; all widths together, bisected; each width alone, from there down, which tells how much noise each value adds; a start
// where those noises, added up, just reach the target; then descent, which lowers one or two widths, raises another in exchange, and
// measures what the added noises promise; at its end each width is given a bit more or less, and all others anew, and each cheaper exchange
// of a bit between two widths is measured, until nothing cheaper is found. Near a design that is alike the first two steps are left out. It
// is a search: a local optimum, no proof. The order of measurements depends on nothing but the answers. No model of hardware.

#include <functional>
#include <optional>
#include <vector>

namespace bump {

/// Bits, in the order of the ranges.
using Widths = std::vector<int>;
/// Compared lexicographically: what is to be small, then what decides between equals.
using FitCost = std::vector<double>;

struct WidthRange {
  int low = 0, high = 0;  ///< inclusive
};

struct FitProblem {
  std::vector<WidthRange> ranges;
  double target = 0;  ///< dB
  /// Nothing for widths that contradict one another. Asked often: it has to be quick.
  std::function<std::optional<FitCost>(const Widths&)> cost;
  /// Qualities in dB, one for each of the widths, which differ; minus infinity for a design that fails. What is below `floor` need not be
  /// exact: any value from the true one to the floor will do.
  std::function<std::vector<double>(const std::vector<Widths>&, double floor)> measure;
  int limit = 300;  ///< designs measured at most, at least 1

  /// Widths of a design like this one, to begin near instead of at the widest; nothing for a width that it does not have. Empty: none.
  std::vector<std::optional<int>> near{};
  FitCost bound{};            ///< not empty: only designs that cost less are of use
  std::size_t patience = 64;  ///< designs measured in vain before a descent ends
};

struct FitAnswer {
  Widths widths;       ///< the cheapest that reach the target; if none does, those of the best quality
  double quality = 0;  ///< theirs; minus infinity if every design failed
  FitCost cost;        ///< empty if every design failed
  bool reached = false;
  bool complete = true;  ///< false: the limit ended the search
  int measured = 0;      ///< designs
};

FitAnswer search_widths(const FitProblem& problem);

}  // namespace bump
