#include "testbench/results/run_report.h"

#include <sys/resource.h>

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

void measure_quality(RunReport& report, const FrameBuffer* reference, const FrameBuffer* blinn) {
  const SimulationResult& result = *report.result;
  report.against_double = compare_frames(result.hardware, result.exact);
  if (reference) {
    report.against_reference = compare_frames(result.hardware, *reference);
    report.double_against_reference = compare_frames(result.exact, *reference);
    report.error_picture = error_image(result.hardware, *reference);
  }
  if (blinn) report.against_blinn = compare_frames(result.hardware, *blinn);
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
