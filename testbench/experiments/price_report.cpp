#include "testbench/experiments/price_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "datapath/invariant.h"

namespace bump {

namespace {

std::vector<std::string> away_from_default(const Configuration& configuration) {
  std::vector<std::string> changed;
  for (const auto& [key, entry] : configuration.entries()) {
    const Parameter& parameter = *configuration.parameters().find(key);
    if (entry.value == parameter.fallback) continue;
    changed.push_back(key + "=" + to_string(entry.value) + " (default " + to_string(parameter.fallback) + ")");
  }
  return changed;
}

SchemePrice priced(const Scheme& scheme, const Configuration& configuration, const PriceBook& book, const PriceOptions& options) {
  try {
    return price_scheme(scheme, configuration, book, options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    SchemePrice none;
    none.page = &scheme.page();
    none.error = error;
    return none;
  }
}

std::size_t index_of(const std::vector<const Scheme*>& schemes, const Scheme* scheme) {
  const auto found = std::find(schemes.begin(), schemes.end(), scheme);
  BUMP_ASSERT(found != schemes.end());
  return static_cast<std::size_t>(found - schemes.begin());
}

void add_break_even(const PriceReportOptions& options, PriceReport& report) {
  const std::array<std::size_t, 2> compared = {index_of(options.schemes, (*options.break_even)[0]),
                                               index_of(options.schemes, (*options.break_even)[1])};
  for (const std::size_t index : compared)
    if (report.schemes[index].error) throw *report.schemes[index].error;
  report.compared = compared;
  report.break_even = break_even(report.schemes[compared[0]], report.schemes[compared[1]]);
  report.excluded_effects = excluded_effects(report.schemes[compared[0]], report.schemes[compared[1]]);
}

}  // namespace

PriceReport make_price_report(const Configuration& configuration, const PriceBook& book, const PriceReportOptions& options) {
  if (book.area == nullptr && book.energy == nullptr)
    throw Error({"no price table is named", {}, "there is nothing to price by", "--prices osu018_model"});
  PriceReport report;
  report.book = book;
  report.real_bits = options.real_bits;
  report.settings = away_from_default(configuration);
  std::vector<WorkOutcome> outcomes(options.schemes.size());
  if (options.scene != nullptr) {
    report.scene = options.scene->name;
    outcomes = executed_work(*options.scene, options.schemes, configuration, options.work);
  }
  for (std::size_t i = 0; i < options.schemes.size(); ++i) {
    PriceOptions one;
    one.real_bits = options.real_bits;
    one.scene = options.scene;
    one.work = outcomes[i].work ? &*outcomes[i].work : nullptr;
    if (outcomes[i].error) {
      SchemePrice none;
      none.page = &options.schemes[i]->page();
      none.error = outcomes[i].error;
      report.schemes.push_back(std::move(none));
    } else {
      report.schemes.push_back(priced(*options.schemes[i], configuration, book, one));
    }
  }
  if (options.break_even) add_break_even(options, report);
  return report;
}

const SchemePrice* worst_failure(const PriceReport& report) {
  const SchemePrice* worst = nullptr;
  for (const SchemePrice& price : report.schemes)
    if (price.error && (worst == nullptr || price.error->kind() > worst->error->kind())) worst = &price;
  return worst;
}

std::string format_price_report(const PriceReport& report, const std::string& format, bool items) {
  if (format == "csv") return price_csv(report);
  if (format == "json") return price_json(report);
  return price_document(report, format == "md", items);
}

std::vector<UsedEntry> used_entries(const PriceReport& report) {
  std::map<std::pair<Quantity, Component>, UsedEntry> used;
  const auto add = [&](Quantity quantity, const CostSheet& sheet, double in_totals, std::map<Component, double>& counts) {
    const PriceTable& table = *report.book.of(quantity);
    for (const PricedItem& item : sheet.items) {
      const Component component = table.entry_component(quantity, item.item.component);
      UsedEntry& entry = used.try_emplace({quantity, component}, UsedEntry{quantity, component, item.entry, {}, 0}).first->second;
      std::vector<Component>& others = entry.standing_in;
      if (component != item.item.component && std::find(others.begin(), others.end(), item.item.component) == others.end())
        others.push_back(item.item.component);
      if (item.entry->is_excluded()) entry.excluded = std::max(entry.excluded, counts[component] += item.item.count * in_totals);
    }
  };
  for (const SchemePrice& price : report.schemes) {
    std::map<Component, double> areas, energies;
    for (const UnitPrice& unit : price.units) {
      const bool counts = unit.role != UnitPrice::Role::apart;
      if (unit.area) add(Quantity::area, *unit.area, counts ? 1 : 0, areas);
      if (unit.energy) add(Quantity::energy, *unit.energy, counts ? unit.executions.value_or(0) : 0, energies);
    }
    if (price.traffic) add(Quantity::energy, *price.traffic, 1, energies);
  }
  std::vector<UsedEntry> result;
  for (auto& [key, entry] : used) result.push_back(std::move(entry));
  return result;
}

std::string excluded_names(const PriceReport& report, Quantity quantity) {
  std::string list;
  for (const UsedEntry& used : used_entries(report))
    if (used.quantity == quantity && used.excluded > 0) list += (list.empty() ? "" : ", ") + std::string(name_of(used.component));
  return list;
}

std::string never_priced(Quantity quantity) {
  return quantity == Quantity::area ? "clock trees, wires, control, FIFOs, caches and memories"
                                    : "clock trees, wires, control, FIFOs, leakage";
}

std::string sizes_text(const PriceItem& item) {
  std::string text;
  const std::vector<std::string>& sizes = sizes_of(item.component);
  for (std::size_t i = 0; i < sizes.size(); ++i) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", sizes[i], item.size[i]);
  return text;
}

}  // namespace bump
