#pragma once
// What the readable formats of a comparison show: a few tables of words, one row a scheme, by subject.

#include <array>
#include <string>
#include <vector>

#include "testbench/experiments/compare.h"

namespace bump {

struct ComparisonTable {
  struct Column {
    std::string group;  ///< what neighbouring columns have in common, or ""
    std::string header;
    bool left = false;  ///< words; numbers stand on the right
  };
  std::string title, note;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
};

std::vector<ComparisonTable> comparison_tables(const Comparison& comparison);

/// "512 x 512 pixels, 1 light, dated engine, 100 MHz".
std::string conditions_of(const Comparison& comparison);
/// Keys whose value is not the default: key, value, default.
std::vector<std::array<std::string, 3>> differences_of(const Configuration& configuration);
/// "default", or what differs from it in one line.
std::string settings_of(const Comparison& comparison);

}  // namespace bump
