#pragma once
// Where price tables are: $BUMPSIM_PRICES, beside the program, or the source tree it was built from.

#include <string>
#include <vector>

#include "testbench/experiments/price_table.h"

namespace bump {

/// A name without folder and suffix is a shipped table, anything else a path. Throws Error(input) naming the shipped tables.
std::string find_price_table(const std::string& name_or_path);

/// Finds and reads each.
std::vector<PriceTable> read_price_tables(const std::vector<std::string>& names_or_paths);

}  // namespace bump
