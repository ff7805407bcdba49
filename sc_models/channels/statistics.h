#pragma once
// What every statistic of the timing plane means: one line each with its unit and, where it is derived, its formula in the symbols of
// timing_graph.h. The texts go into stats.csv and the documentation, so that no number is printed without its meaning.

#include <string>
#include <vector>

namespace bump {

struct StatisticMeaning {
  std::string module_kind;  ///< "run", "stage", "fifo", "memory"
  std::string statistic;    ///< name of the field in TimingResult
  std::string unit;         ///< "cycles", "tokens", "requests"
  std::string meaning;      ///< one line
  std::string formula;      ///< "" when it is simply counted
};

/// One entry for each numeric field of TimingResult, kind by kind, in the order of the fields.
std::vector<StatisticMeaning> statistic_meanings();

}  // namespace bump
