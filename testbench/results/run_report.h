#pragma once
// Everything that one run has to say, collected for the result folder and for the summary on the terminal. Refers to what it describes; it
// owns only what was measured afterwards. No model of hardware.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "system/simulation.h"
#include "testbench/reference/quality.h"
#include "units/scene.h"

namespace bump {

/// What depends on the machine and the moment: the only part of a result that differs from run to run.
struct HostFacts {
  double wall_s = 0;           ///< simulation alone, without reading the scene and drawing references
  double fragments_per_s = 0;  ///< fragments simulated in a second of wall time
  double peak_rss_mib = 0;     ///< largest resident memory of the process so far
  std::string compiler;        ///< "g++ 12.2.0"
  std::string version;         ///< "bumpsim 0.1.0"
};

/// Fills in the peak memory of this process and the rate.
HostFacts host_facts(double wall_s, std::int64_t fragments, const std::string& compiler, const std::string& version);

struct RunReport {
  const Scene* scene = nullptr;
  const Scheme* scheme = nullptr;
  const Configuration* configuration = nullptr;  ///< may be null: then there is no `config`
  const SimulationResult* result = nullptr;
  std::string engine = "dated";
  std::string status = "ok";
  std::string resolved_toml;  ///< text of config.resolved.toml
  std::vector<std::string> warnings{};  ///< of the scene's reader, of the scheme on this scene, and of the run: one sentence each
  std::string out;            ///< the result folder, for the summary; empty when nothing is written
  HostFacts host;

  // Absent when not measured.
  std::optional<Quality> against_reference;         ///< hardware's image, reference from the same map
  std::optional<Quality> against_double;            ///< hardware's image, the scheme's own double evaluation: quantisation error
  std::optional<Quality> against_blinn;             ///< hardware's image, Blinn's reference from the heights
  std::optional<Quality> double_against_reference;  ///< the scheme's double evaluation, reference from the same map: model error
  std::optional<FrameBuffer> error_picture;         ///< hardware's image against the reference, quality.h
};

/// Measures the images of report.result: always against the scheme's double evaluation, and against the references that are given (null:
/// not). `threads` share the comparisons. The error picture is left to error_image(), for those who want it.
void measure_quality(RunReport& report, const FrameBuffer* reference, const FrameBuffer* blinn, int threads = 1);

// Numbers that several outputs share. Absent where the denominator is 0.
std::optional<double> fragments_per_cycle(const SimulationResult& result);
std::optional<double> frames_per_second(const SimulationResult& result);  ///< at the configured clock
std::optional<double> hit_rate(const TextureCounters& texture);           ///< hits / cache look-ups
std::optional<double> hit_rate(const LightMapCounters& map);              ///< hits / reads

}  // namespace bump
