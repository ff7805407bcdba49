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

/// Median seconds of each variant over `rounds` rounds, in the order of the variants. Throws what a variant throws.
inline std::vector<double> interleaved(const std::vector<Variant>& variants, int rounds) {
  std::vector<std::vector<double>> taken(variants.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const ChildTask task{variants[i].name, [&](const ReportShare&) { return fmt::format("{:.17g}", variants[i].seconds()); }};
      ChildOptions one;
      one.jobs = 1;
      const ChildOutcome outcome = run_in_children({task}, one).front();
      if (outcome.error) throw Error(*outcome.error);
      taken[i].push_back(std::strtod(outcome.bytes.c_str(), nullptr));
    }
  }
  std::vector<double> medians;
  for (const std::vector<double>& each : taken) medians.push_back(median(each));
  return medians;
}

}  // namespace bump::bench
