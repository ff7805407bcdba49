#pragma once
// Table 1 in the four output formats. The two for readers are one document in two spellings; the two for programs hold every value.
// Internal to table1.cpp; no hardware, no time.

#include <string>

#include "testbench/experiments/table1.h"

namespace bump {

inline constexpr int table1_json_version = 1;

/// At most 140 columns as text; Markdown leaves the width to the viewer.
std::string table1_document(const Table1& table, bool markdown);
/// Tidy: section, scheme, step, settings, quantity, unit, derived, published, difference, reconstruction, agreement, why; one value a line.
std::string table1_csv(const Table1& table);
/// One object of schema "bumpsim-table1".
std::string table1_json(const Table1& table);

/// Whole numbers as such, others with at most two decimals.
std::string table1_number(double value);

}  // namespace bump
