#pragma once
// At which cost of tables two schemes are equal: the cost of each as a line, everything but tables plus tables times what one unit of them
// costs, and where the lines cross. Units are a stored bit (area), a read (energy), and the price table's own prices as a whole, by which
// a reader sees how far they may be off before the ranking changes. A second port stores nothing: per bit, it keeps its own price. And
// what the price table excludes: at which price of it the ranking would change. No hardware, no time.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "testbench/experiments/price.h"

namespace bump {

struct CostLine {
  double rest = 0;    ///< bump mapping without tables; energy: of a fragment, memory traffic included if a scene was given
  double tables = 0;  ///< units of tables
  double own = 0;     ///< what a unit costs by the price table, on average; 0 without tables

  double at(double cost) const { return rest + cost * tables; }
};

struct BreakEven {
  Quantity quantity = Quantity::area;
  std::string unit;  ///< "NAND2 a table bit", "pJ a table read", "times the prices of tables"
  std::array<CostLine, 2> lines;
  std::optional<double> at;    ///< > 0; missing if one scheme wins at any cost
  int below = -1, above = -1;  ///< index of the cheaper scheme on either side, the same without a break-even; -1: equal

  /// The cheaper one at this cost; -1: equal.
  int winner(double cost) const;
};

/// A component that no total has, because the table excludes it, against the ranking by what the totals have.
struct ExcludedEffect {
  Quantity quantity = Quantity::area;
  Component component = Component::adder;
  std::array<double, 2> amounts{};  ///< bits or pieces (LeftOut) of bump mapping; energy: for a fragment
  int ahead = -1;                   ///< the scheme that costs less by the table; -1: equal
  std::optional<double> at;         ///< price of a bit or piece above which the other one costs less; missing: no price does that
};
std::vector<ExcludedEffect> excluded_effects(const SchemePrice& first, const SchemePrice& second);

/// For each quantity that both are priced in. Neither has an error.
std::vector<BreakEven> break_even(const SchemePrice& first, const SchemePrice& second);

/// Fills in, from the lines, where they cross and who wins.
void find_break_even(BreakEven& point);

}  // namespace bump
