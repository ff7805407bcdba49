#pragma once
// A Pareto front as text and Markdown (the front alone), as CSV and JSON (every point, marked) and as a plot. No model of hardware.

#include <string>

#include "testbench/experiments/pareto.h"

namespace bump {

constexpr const char* pareto_schema = "bumpsim-pareto";
constexpr int pareto_schema_version = 1;

std::string pareto_document(const ParetoFront& front, bool markdown);
std::string pareto_csv(const ParetoFront& front);
std::string pareto_json(const ParetoFront& front);
/// `title`: empty for one of the columns' names.
std::string pareto_svg(const ParetoFront& front, const std::string& title);

/// "table_bits (bits)": the name and the unit that it ends in, where it is one of the program's.
std::string axis_title(const ParetoAxis& axis);

}  // namespace bump
