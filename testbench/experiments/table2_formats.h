#pragma once
// Table 2 in the four output formats, and the sentences that its numbers support. The formats for readers are one document in two
// spellings; those for programs hold every value. Nothing here measures anything.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "testbench/experiments/table2.h"

namespace bump {

class Document;

inline constexpr int table2_json_version = 1;

/// "text", "md", "csv" or "json"; ends with a line break.
std::string table2_text(const Table2& table, const Configuration& configuration, const std::string& format);

/// Plain text or Markdown.
std::string table2_document(const Table2& table, const Configuration& configuration, bool markdown);
/// Tidy: section, scene, space, test, reference, measure, channel, unit, published, measured, ratio; one value a line.
std::string table2_csv(const Table2& table);
/// One object of schema "bumpsim-table2"; what Table 2 holds is {published, measured, ratio}, null where there is nothing.
nlohmann::ordered_json table2_json(const Table2& table, const Configuration& configuration);

/// What reproduces and what cannot, every number in it computed from the table or from the published one. One paragraph each.
std::vector<std::string> table2_findings(const Table2& table);

// What the formats share.
/// A measure of Table 2: its name and where it is.
struct Table2Measure {
  const char* name;
  std::array<double, 3> WholeFrameMeasures::*measured;
  std::array<double, 3> published::Table2Row::*published;
};
const std::array<Table2Measure, 4>& table2_measures();
/// Mean of the three channels.
double mean(const std::array<double, 3>& channels);
/// "set by the user": keys that are not at their default, with their values.
std::vector<std::string> changed_settings(const Configuration& configuration);
/// One line each: what the picture called "proposed", "kim", "conventional" or "blinn" is in this table.
std::string title_of(const std::string& method, const Table2& table);

/// Lowest, median and highest of the finite values; NaN if there are none.
struct Spread {
  double low, middle, high;
  explicit Spread(std::vector<double> values);
};
/// "0.75", "4.70", "37": a ratio to published values with no more digits than those bear.
std::string times(double value);

// The filter of the bump map (table2_filter_report.cpp).
/// "nearest texel" and the like, for a value of <scheme>.map_filter.
std::string title_of_filter(const std::string& filter);
/// Which filters the table's own pictures have, and why.
std::string filter_assumption(const Table2& table);
/// The section with every filter.
void filter_section(Document& document, const Table2& table);
/// Which share of the error is the filter's, and which the method's.
std::vector<std::string> filter_findings(const Table2& table);

}  // namespace bump
