#pragma once
// Small runs, recorded, and random settings of time. For tests only.

#include <random>
#include <string>
#include <vector>

#include "../units/samples.h"
#include "retiming/retimer.h"
#include "retiming/trace_file.h"
#include "testbench/experiments/child_processes.h"

namespace bump::test {

/// A sphere behind another, 32 x 24 pixels: hidden fragments, triangles without any, misses.
inline Scene retime_scene() {
  return samples::scene(
      {samples::object(samples::sphere(6)), samples::object(samples::sphere(4), glm::translate(glm::dmat4(1), glm::dvec3(0.4, 0.2, -1)))},
      32, 24);
}

struct Settings {
  std::vector<std::pair<std::string, std::string>> values;
  Configuration applied_to(Configuration configuration) const {
    for (const auto& [key, value] : values) configuration.set_text(key, value, {"test", 0, 0});
    return configuration;
  }
};

/// Some of the parameters that are only timing, each at random but not so large that a test takes long.
inline Settings random_timing_settings(std::mt19937_64& random, const Parameters& parameters, bool batches = true) {
  Settings settings;
  for (const auto& [key, parameter] : parameters.all()) {
    if (!parameter.timing_only || random() % 3 != 0) continue;
    if (!batches && key == "texture_fetch.batch") continue;
    const auto low = static_cast<std::uint64_t>(parameter.low), high = static_cast<std::uint64_t>(parameter.high);
    if (low > high || key == "clock.megahertz") continue;
    const std::uint64_t most = random() % 4 == 0 ? 60 : 7;
    settings.values.emplace_back(key, std::to_string(std::min(high, low + random() % (most + 1))));
  }
  return settings;
}

/// Everything that a run says of time, for comparison as text.
inline std::string text_of(const TimingResult& timing, const Bound& bound) {
  std::string text = std::to_string(timing.cycles) + " " + std::to_string(bound.cycles) + " " + bound.by + "\n";
  const auto line = [&text](const std::string& name, std::initializer_list<std::int64_t> numbers) {
    text += name;
    for (const std::int64_t number : numbers) text += " " + std::to_string(number);
    text += "\n";
  };
  for (const StageStatistics& s : timing.stages)
    line(s.name, {s.tokens, s.busy, s.starved, s.blocked_room, s.blocked_output, s.last_delivery});
  for (const FifoStatistics& f : timing.fifos) line(f.name, {f.depth, f.items, f.max_occupancy, f.full_cycles, f.empty_cycles});
  for (const MemoryStatistics& m : timing.memories) line(m.name, {m.requests, m.busy});
  return text;
}

/// A run that is recorded, and what it says of time; a deadlock is its report.
inline ChildTask recorded_run(const std::string& scheme, const Configuration& configuration, bool with_trace, bool with_addresses = false) {
  return {scheme, [=](const ReportShare&) {
            const Scene scene = retime_scene();
            TraceRecorder recorder;
            SimulationOptions options;
            options.measure = false;
            if (with_trace) options.record = [&recorder](const TimingRecords& records) { recorder.add(records); };
            if (with_addresses) options.accesses = &recorder.accesses();
            try {
              const SimulationResult result = simulate(scene, find_scheme(scheme), configuration, options);
              if (with_trace) return encode_trace(recorder.finish(scene, find_scheme(scheme), configuration, result.timing.cycles));
              return text_of(result.timing, result.bound);
            } catch (const Error& error) {
              if (error.kind() != ErrorKind::deadlock) throw;
              return std::string(error.what());
            }
          }};
}

inline std::vector<std::string> outcomes_of(const std::vector<ChildTask>& tasks) {
  std::vector<std::string> texts;
  for (const ChildOutcome& outcome : run_in_children(tasks, {})) {
    if (outcome.error) throw *outcome.error;
    texts.push_back(outcome.bytes);
  }
  return texts;
}

inline TimingTrace record(const std::string& scheme, const Settings& settings = {}) {
  const Configuration configuration = settings.applied_to(Configuration(all_parameters()));
  return decode_trace(outcomes_of({recorded_run(scheme, configuration, true)}).front(), "test.trace");
}

}  // namespace bump::test
