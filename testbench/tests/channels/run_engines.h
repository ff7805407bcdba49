#pragma once
// Runs cases under both engines. SystemC elaborates once per process, so many clocked engines share one simulation, each with its own
// clock.

#include <memory>
#include <optional>

#include "channels/stepped_engine.h"
#include "channels/timeline.h"
#include "datapath/error.h"
#include "random_timing.h"

namespace bump::test {

/// A result, or the text of the error that took its place.
struct Outcome {
  TimingResult result;
  std::string error;
  std::string remedy;
};

template <class Run>
Outcome outcome_of(Run run) {
  try {
    return {run(), "", ""};
  } catch (const Error& error) {
    return {{}, error.what(), error.text().try_this};
  }
}

/// All records at once when `seed` is 0, else in random blocks with dating in between.
inline Outcome run_dated(const TimingCase& timing_case, std::uint64_t seed = 0) {
  Timeline timeline(timing_case.graph);
  if (seed == 0) {
    for (std::size_t i = 0; i < timing_case.records.size(); ++i)
      timeline.append(static_cast<int>(i), timing_case.records[i].data(), timing_case.records[i].size());
  } else {
    Random random(seed);
    std::vector<std::size_t> used(timing_case.records.size(), 0);
    while (append_block(timeline, timing_case, used, random))
      if (random.chance(60)) timeline.advance();
  }
  return outcome_of([&] { return timeline.finish(); });
}

/// Call once per process.
inline std::vector<Outcome> run_stepped(const std::vector<TimingCase>& cases) {
  struct Run {
    Random random{0};
    std::vector<std::size_t> used;
    std::unique_ptr<SteppedEngine> engine;
  };
  std::vector<Run> runs(cases.size());
  std::size_t running = cases.size();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Run& run = runs[i];
    run.random = Random(i + 1);
    run.used.assign(cases[i].records.size(), 0);
    run.engine =
        std::make_unique<SteppedEngine>(("engine" + std::to_string(i)).c_str(), cases[i].graph, sc_core::sc_time(10, sc_core::SC_NS),
                                        [&run, &one = cases[i]] { return append_block(*run.engine, one, run.used, run.random); },
                                        [&running] {
                                          if (--running == 0) sc_core::sc_stop();
                                        });
  }
  sc_core::sc_start();
  std::vector<Outcome> outcomes;
  for (Run& run : runs) outcomes.push_back(outcome_of([&] { return run.engine->result(); }));
  return outcomes;
}

}  // namespace bump::test
