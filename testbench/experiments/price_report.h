#pragma once
// Schemes with their prices as one report, in four formats: text and Markdown for readers, CSV (one amount a line) and JSON (everything,
// versioned) for programs. Every total names its table and what that table says of its accuracy. No hardware, no time.

#include <optional>
#include <string>
#include <vector>

#include "testbench/experiments/price.h"
#include "testbench/experiments/price_break_even.h"

namespace bump {

inline constexpr const char* price_schema = "bumpsim-price";
inline constexpr int price_schema_version = 1;

struct PriceReport {
  PriceBook book;
  std::vector<SchemePrice> schemes;
  std::string scene;                                   ///< empty: none
  int real_bits = 0;                                   ///< as PriceOptions
  std::vector<std::string> settings;                   ///< "key=value (default ...)" of every parameter away from its default
  std::optional<std::array<std::size_t, 2>> compared;  ///< indices of the schemes of a break-even
  std::vector<BreakEven> break_even;
  std::vector<ExcludedEffect> excluded_effects;  ///< with a break-even
};

struct PriceReportOptions {
  std::vector<const Scheme*> schemes;
  std::optional<std::array<const Scheme*, 2>> break_even;  ///< both are among `schemes`
  int real_bits = 0;
  const Scene* scene = nullptr;
  WorkOptions work;
};

/// Schemes that cannot be priced are rows with their error. Throws Error(input) if there is no table, or a break-even needs a scheme that
/// has no price; Error(cancelled). With a scene, call before this process elaborates SystemC.
PriceReport make_price_report(const Configuration& configuration, const PriceBook& book, const PriceReportOptions& options);

/// The first scheme without prices with the worst error; null if there is none.
const SchemePrice* worst_failure(const PriceReport& report);

/// `format`: "text", "md", "csv" or "json". `items`: list every component of every unit (CSV and JSON do).
std::string format_price_report(const PriceReport& report, const std::string& format, bool items);

/// Parts of it: price_document.cpp, price_data.cpp.
std::string price_document(const PriceReport& report, bool markdown, bool items);
std::string price_csv(const PriceReport& report);
std::string price_json(const PriceReport& report);

/// An entry that the report uses.
struct UsedEntry {
  Quantity quantity;
  Component component;  ///< whose entry it is
  const PriceEntry* entry;
  std::vector<Component> standing_in;  ///< special cases without entry that it prices
  double excluded = 0;                 ///< if it is excluded: how many the totals lack, of the scheme that has most
};
/// In order of quantity and component.
std::vector<UsedEntry> used_entries(const PriceReport& report);

/// What no total of the report has, because the table excludes it: "clamp, select"; empty if there is nothing.
std::string excluded_names(const PriceReport& report, Quantity quantity);
/// What no price here has, by any table.
std::string never_priced(Quantity quantity);

/// "rows 12, width 13"; empty without sizes.
std::string sizes_text(const PriceItem& item);

}  // namespace bump
