#pragma once
// A comparison as text with columns that line up (for a terminal), Markdown, CSV (one row a scheme, every metric, units in the names) and
// JSON (the same and each run's whole result). Not applicable is "-", an empty field, or null; never 0. Schemes that are reconstructions
// are marked in all of them.

#include <string>

#include "testbench/experiments/compare.h"

namespace bump {

constexpr const char* comparison_schema = "bumpsim-comparison";
constexpr int comparison_schema_version = 1;

std::string comparison_text(const Comparison& comparison);
std::string comparison_markdown(const Comparison& comparison);
/// With a header, RFC 4180 quoting, lines ended by "\n".
std::string comparison_csv(const Comparison& comparison);
/// `version` is the program's. Holds nothing that depends on the machine or the moment.
std::string comparison_json(const Comparison& comparison, const std::string& version);

}  // namespace bump
