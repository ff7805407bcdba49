#pragma once
// The light-map fetch unit, between environment and illumination unit of designs that have light maps (schemes/scheme.h): forms the address
// of a fragment's words by the design's address netlist, and reads one word of each map, the nearest entry, through a cache of its own from
// a bank of memory of its own (Kugler 1998 puts the logic into the memory chip that holds the maps, so they do not contend with textures).
// A dependent fetch: the request leaves when the address is known, the schedule's latency and the tag latency after the start. A token is
// a fragment; its interval is the greater of the address netlist's and the number of maps over the reads served each cycle. The maps hold
// all lights, so a fragment passes once. They are filled before the frame (light_map_fill.h), in no time. It leaves out filters, and the
// writing of the maps into memory. Source: Kugler 1998 as Lee 2007 describes it.

#include <cstdint>
#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "memory/texture_cache.h"
#include "units/counters.h"
#include "units/datapath_unit.h"
#include "units/light_map_fill.h"
#include "units/light_map_layout.h"

namespace bump {

class AccessListener;

struct LightMapFetchConfig {
  int reads_per_cycle = 2;  ///< words that the cache serves each cycle
  CacheGeometry cache;

  /// Also declares what only the timing plane reads: multipliers, latency and capacity of the unit, and the memory port ("light_memory.*").
  static void declare(Parameters& parameters);
  /// Parameters that decide nothing but which look-ups hit and how long they take, as TextureFetchConfig::look_up_keys() says.
  static std::vector<std::string> look_up_keys();
  LightMapFetchConfig() = default;
  /// Throws Error(input) if the cache geometry is not a power of two where it must be.
  explicit LightMapFetchConfig(const Configuration& configuration);
};

/// Planes, all of PipelineContext: "light_map.base" in, "light.<name>" out; the address netlist's outputs on the way. The hardware's words
/// come from the maps; the double evaluation takes the maps' continuous function at the direction that its own coordinates mean.
class LightMapFetch {
 public:
  /// The designs have light maps. Throws Error(input) if the scene has more objects than an address can tell apart, or a word does not
  /// fit into a line.
  LightMapFetch(std::shared_ptr<const PipelineContext> context, const LightMapFetchConfig& config);
  void process(FragmentBlock& block);
  /// Tells the listener of all reads that follow. It must outlive this.
  void listen(AccessListener& listener) { listener_ = &listener; }

  /// Where the words lie. Throws Error(input) if one does not fit into a line.
  static LightMapLayout layout_of(const LightMaps& maps, int line_bytes);

  /// Times the address netlist was executed: fragments.
  std::int64_t executions() const { return address_.executions(); }
  /// By map.
  const std::vector<LightMapCounters>& counters() const { return counters_; }
  /// Entries of all objects' maps, of one map each.
  std::int64_t words_written() const;
  /// Executions of the frame netlist: entries times lights times objects.
  std::int64_t fill_executions() const { return context_->lights > 0 ? words_written() : 0; }
  int word_bytes(int map) const { return layout_.word_bytes(map); }

 private:
  void start_object(int object);
  /// The hardware's entry of every fragment, within the object's maps.
  void find_entries(const FragmentBlock& block);
  void fetch(FragmentBlock& block);
  void evaluate_exact(FragmentBlock& block);
  LightMapFill& fill_of(int object);

  std::shared_ptr<const PipelineContext> context_;
  LightMapFetchConfig config_;
  LightMapLayout layout_;
  TextureCache cache_;
  DatapathUnit address_;
  /// In double-precision runs: the address netlist in fixed point, for the addresses that the cache sees. One per design.
  std::vector<std::unique_ptr<Evaluator>> entry_evaluators_;
  std::vector<std::unique_ptr<LightMapFill>> fills_;  ///< one per design
  int object_ = -1;                                   ///< whose maps `words_` holds: fragments arrive object by object
  LightMapWords words_;
  AccessListener* listener_ = nullptr;
  std::vector<std::int64_t> entries_;  ///< of the block's fragments, within the object's maps
  std::vector<glm::dvec3> normals_;
  std::vector<Lanes> sums_;
  std::vector<LightMapCounters> counters_;
  int base_plane_ = 0, entry_plane_ = 0, word_plane_ = 0;  ///< word_plane_: the first map's, others follow
  std::vector<int> coordinate_planes_;
};

}  // namespace bump
