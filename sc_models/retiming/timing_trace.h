#pragma once
// What timing needs of one run, recorded once: the records of the stages whose tokens differ (triangles through vertex processor and
// triangle setup; fragments, and triangles without any, through the rasterizer; fragments through texture and light-map fetch), and all
// from which the rest follows: the schedules of the netlists are a function of scheme, configuration, materials and lights, so these are
// kept, with a hash of the netlists that tells whether the program still builds the same. Every date under any depths, latencies,
// capacities, multiplier limits and memory ports can be computed from it, and no value of a fragment is needed. With what the fetch units
// read, the same holds for the geometry of their caches (cache_replay.h). No hardware.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "channels/parameters.h"
#include "retiming/access_recorder.h"
#include "retiming/token_stream.h"
#include "schemes/scheme.h"
#include "system/timing_feed.h"
#include "units/scene.h"

namespace bump {

/// Stages with records of their own; the others' tokens are all alike.
namespace traced {
enum Index : std::size_t { vertex, setup, raster, texture, light_map, count };
}

struct TimingTrace {
  std::string scheme, scene;
  int width = 0, height = 0;
  std::vector<Scene::InputFile> inputs;                            ///< files of the scene with their hashes
  std::vector<Material> materials;                                 ///< distinct ones, in order of the objects
  std::vector<double> lights;                                      ///< intensities
  std::vector<std::pair<std::string, std::string>> configuration;  ///< every parameter of the recorded run, with its value as text
  std::string netlists;                                            ///< hash_of_netlists()
  std::int64_t cycles = 0;                                         ///< of the recorded run
  std::array<TokenStream, traced::count> streams;                  ///< light_map is empty for designs without light maps

  RecordedAccesses accesses;  ///< what the fetch units read, if that was recorded

  /// Whether hits and misses can be told for other caches.
  bool has_addresses() const { return accesses.texels.fragments == fragments(); }
  std::int64_t triangles() const { return streams[traced::vertex].tokens; }
  std::int64_t fragments() const { return streams[traced::texture].tokens; }
};

/// Throws Error(internal) naming what contradicts itself: token counts of neighbouring stages, masks, intervals of 0, addresses.
void check_trace(const TimingTrace& trace);

/// What the program builds for a trace's scheme, materials and lights.
struct TracedDesign {
  Design design;  ///< of the first material; others differ in constants and contents of tables
  Netlist colour;
  int passes = 1;
};
/// `scene` needs lights and the materials of objects only.
TracedDesign make_traced_design(const Scene& scene, const Scheme& scheme, const Configuration& configuration);
/// The same from a trace.
TracedDesign make_traced_design(const TimingTrace& trace, const Scheme& scheme, const Configuration& configuration);
/// SHA-256 of everything in the per-pixel netlists that their schedules depend on.
std::string hash_of_netlists(const TracedDesign& design);

/// Collects the records of a run, as SimulationOptions::record hands them out.
class TraceRecorder {
 public:
  void add(const TimingRecords& records);
  /// For SimulationOptions::accesses: the trace has addresses then.
  AccessListener& accesses() { return accesses_; }
  /// The trace, once, when the simulation is over. `cycles` is its result.
  TimingTrace finish(const Scene& scene, const Scheme& scheme, const Configuration& configuration, std::int64_t cycles);

 private:
  std::array<TokenStreamBuilder, traced::count> builders_;
  AccessRecorder accesses_;
};

}  // namespace bump
