#pragma once
// A fit as text, Markdown, CSV (one row a scheme, units in the names, readable by `bumpsim pareto`) and JSON. A scheme that does not reach
// the quality is a row that says so and how far the best of its designs came; not applicable is "-", an empty field, or null.

#include <string>

#include "testbench/experiments/fit.h"

namespace bump {

constexpr const char* fit_schema = "bumpsim-fit";
constexpr int fit_schema_version = 2;

/// For readers, in plain text or Markdown.
std::string fit_document(const Fit& fit, bool markdown);
/// With a header, RFC 4180 quoting, lines ended by "\n".
std::string fit_csv(const Fit& fit);
/// `version` is the program's.
std::string fit_json(const Fit& fit, const std::string& version);

/// "reached", "not_reached", or what error_json.h calls the error.
std::string status_of(const FitRow& row);

}  // namespace bump
