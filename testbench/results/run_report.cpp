#include "testbench/results/run_report.h"

#include <sys/resource.h>

#include <vector>

#include "testbench/reference/row_bands.h"

namespace bump {

HostFacts host_facts(double wall_s, std::int64_t fragments, const std::string& compiler, const std::string& version) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  HostFacts facts;
  facts.wall_s = wall_s;
  facts.fragments_per_s = wall_s > 0 ? static_cast<double>(fragments) / wall_s : 0;
  facts.peak_rss_mib = static_cast<double>(usage.ru_maxrss) / 1024;
  facts.compiler = compiler;
  facts.version = version;
  return facts;
}

void measure_quality(RunReport& report, const FrameBuffer* reference, const FrameBuffer* blinn, int threads) {
  const FrameBuffer &hardware = report.result->hardware, &exact = report.result->exact;
  struct Comparison {
    std::optional<Quality>* measures;
    const FrameBuffer *test, *against;
  };
  std::vector<Comparison> comparisons = {{&report.against_double, &hardware, &exact}};
  if (reference) comparisons.push_back({&report.against_reference, &hardware, reference});
  if (reference) comparisons.push_back({&report.double_against_reference, &exact, reference});
  if (blinn) comparisons.push_back({&report.against_blinn, &hardware, blinn});
  for_row_bands(static_cast<int>(comparisons.size()), 1, threads, [&](int first, int) {
    const Comparison& comparison = comparisons[static_cast<std::size_t>(first)];
    *comparison.measures = compare_frames(*comparison.test, *comparison.against);
  });
}

std::optional<double> fragments_per_cycle(const SimulationResult& result) {
  if (result.timing.cycles <= 0) return std::nullopt;
  return static_cast<double>(result.fragments) / static_cast<double>(result.timing.cycles);
}

std::optional<double> frames_per_second(const SimulationResult& result) {
  if (result.timing.cycles <= 0) return std::nullopt;
  return result.clock_megahertz * 1e6 / static_cast<double>(result.timing.cycles);
}

std::optional<double> hit_rate(const TextureCounters& texture) {
  if (texture.accesses <= 0) return std::nullopt;
  return static_cast<double>(texture.hits) / static_cast<double>(texture.accesses);
}

std::optional<double> hit_rate(const LightMapCounters& map) {
  if (map.reads <= 0) return std::nullopt;
  return static_cast<double>(map.hits) / static_cast<double>(map.reads);
}

}  // namespace bump
