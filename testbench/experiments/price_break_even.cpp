#include "testbench/experiments/price_break_even.h"

#include "datapath/invariant.h"

namespace bump {

namespace {

std::optional<CostLine> line_of(const SchemePrice& price, Quantity quantity, bool by_unit) {
  const std::optional<double> total = price.total(quantity, false), tables = price.of(quantity, CostGroup::tables);
  if (!total || !tables) return std::nullopt;
  CostLine line;
  const double ports = by_unit && quantity == Quantity::area ? price.port_prices().value_or(0) : 0;
  line.rest = *total - *tables + ports;
  if (quantity == Quantity::energy && price.traffic) line.rest += price.traffic->total();
  const double units = (quantity == Quantity::area ? price.table_bits() : price.table_reads()).value_or(0);
  line.tables = by_unit ? units : *tables;
  if (line.tables > 0) line.own = (*tables - ports) / line.tables;
  return line;
}

double amount_of(const std::vector<LeftOut>& list, Component component) {
  for (const LeftOut& one : list)
    if (one.component == component) return one.amount;
  return 0;
}

}  // namespace

int BreakEven::winner(double cost) const {
  const double first = lines[0].at(cost), second = lines[1].at(cost);
  return first < second ? 0 : second < first ? 1 : -1;
}

void find_break_even(BreakEven& point) {
  const double slope = point.lines[0].tables - point.lines[1].tables, ahead = point.lines[1].rest - point.lines[0].rest;
  // Free tables: whoever has the smaller rest. Ever dearer tables: whoever has fewer. If that is the same one, or one of the two does not
  // decide, the lines do not cross at a positive cost.
  const int by_rest = ahead > 0 ? 0 : ahead < 0 ? 1 : -1, by_tables = slope < 0 ? 0 : slope > 0 ? 1 : -1;
  point.at.reset();
  point.below = by_rest >= 0 ? by_rest : by_tables;
  point.above = by_tables >= 0 ? by_tables : by_rest;
  if (by_rest >= 0 && by_tables >= 0 && by_rest != by_tables) point.at = ahead / slope;
}

std::vector<ExcludedEffect> excluded_effects(const SchemePrice& first, const SchemePrice& second) {
  std::vector<ExcludedEffect> effects;
  for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
    const std::optional<CostLine> a = line_of(first, quantity, false), b = line_of(second, quantity, false);
    if (!a || !b) continue;
    const std::vector<LeftOut> of_first = first.left_out(quantity, false), of_second = second.left_out(quantity, false);
    const double lead = b->at(1) - a->at(1);  // of the first, by the table's own prices
    for (int c = 0; c < static_cast<int>(Component::count); ++c) {
      ExcludedEffect effect;
      effect.quantity = quantity;
      effect.component = static_cast<Component>(c);
      effect.amounts = {amount_of(of_first, effect.component), amount_of(of_second, effect.component)};
      if (effect.amounts == std::array<double, 2>{}) continue;
      effect.ahead = lead > 0 ? 0 : lead < 0 ? 1 : -1;
      const double more = effect.amounts[0] - effect.amounts[1];  // of the first
      if (lead * more > 0) effect.at = lead / more;
      effects.push_back(effect);
    }
  }
  return effects;
}

std::vector<BreakEven> break_even(const SchemePrice& first, const SchemePrice& second) {
  BUMP_ASSERT(!first.error && !second.error);
  std::vector<BreakEven> result;
  for (const Quantity quantity : {Quantity::area, Quantity::energy}) {
    for (const bool by_unit : {true, false}) {
      const std::optional<CostLine> a = line_of(first, quantity, by_unit), b = line_of(second, quantity, by_unit);
      if (!a || !b) continue;
      BreakEven point;
      point.quantity = quantity;
      point.unit = !by_unit ? "times the prices of tables" : quantity == Quantity::area ? "NAND2 a table bit" : "pJ a table read";
      point.lines = {*a, *b};
      find_break_even(point);
      result.push_back(point);
    }
  }
  return result;
}

}  // namespace bump
