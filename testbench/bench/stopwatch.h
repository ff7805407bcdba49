#pragma once
// Timing of short, repeatable pieces of work within one process, side by side: variants take turns, each turn repeats a variant for about a
// millisecond, and the figures are medians over the turns with the least beside them. On a shared machine only ratios of one run mean
// anything.

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace bump::bench {

struct Work {
  std::string name;
  std::function<void()> once;
};

struct Timing {
  double median = 0, least = 0;  ///< seconds for one call
};

/// Seconds of one call of every work over `turns` turns, in the order of `works`.
inline std::vector<Timing> taking_turns(const std::vector<Work>& works, int turns) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](const Work& work, int calls) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < calls; ++i) work.once();
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  std::vector<int> calls;
  for (const Work& work : works) {
    seconds(work, 1);  // caches and pages
    calls.push_back(std::max(1, static_cast<int>(1e-3 / std::max(1e-7, seconds(work, 4) / 4))));
  }
  std::vector<std::vector<double>> taken(works.size());
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t i = 0; i < works.size(); ++i) taken[i].push_back(seconds(works[i], calls[i]) / calls[i]);
  std::vector<Timing> timings;
  for (std::vector<double>& each : taken) {
    std::sort(each.begin(), each.end());
    timings.push_back({each[each.size() / 2], each.front()});
  }
  return timings;
}

}  // namespace bump::bench
