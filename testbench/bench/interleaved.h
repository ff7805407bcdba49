#pragma once
// Side-by-side timing on a machine that is shared and noisy: variants take turns, every round measures each of them once, and the figures
// are medians and their ratios within one run. Each measurement is a process of its own, as SystemC elaborates once per process.

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "testbench/experiments/child_processes.h"

namespace bump::bench {

struct Variant {
  std::string name;
  std::function<double()> seconds;  ///< does the work in a fresh process and returns what it took
};

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// Seconds of each variant in each round.
struct Interleaved {
  std::vector<std::vector<double>> seconds;  ///< [variant][round]
  double of(std::size_t variant) const { return median(seconds[variant]); }
  /// Median over the rounds of the ratio within a round: what disturbs the machine for longer than a round cancels out.
  double ratio(std::size_t a, std::size_t b) const {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < seconds[a].size(); ++round) ratios.push_back(seconds[a][round] / seconds[b][round]);
    return median(ratios);
  }
};

/// Every variant once in each of `rounds` rounds. Throws what a variant throws.
inline Interleaved interleaved(const std::vector<Variant>& variants, int rounds) {
  Interleaved taken;
  taken.seconds.resize(variants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const ChildTask task{variants[i].name, [&](const ReportShare&) { return fmt::format("{:.17g}", variants[i].seconds()); }};
      ChildOptions one;
      one.jobs = 1;
      const ChildOutcome outcome = run_in_children({task}, one).front();
      if (outcome.error) throw Error(*outcome.error);
      taken.seconds[i].push_back(std::strtod(outcome.bytes.c_str(), nullptr));
    }
  }
  return taken;
}

}  // namespace bump::bench
