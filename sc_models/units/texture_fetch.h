#pragma once
// The texture unit: fetches the colour texel and the bump-map texel of each fragment through one cache, with the configured filter. Filter
// weights are in double precision (their width is left out); the stored bump map is rounded to the scheme's channel formats in fixed-point
// runs. Tags are looked up in order, once per distinct line of a fragment, colour first. A token is a fragment: its interval is the number
// of 2 x 2 footprints (one per texture and mip level) over the footprints served each cycle; its record says how many lines missed, and the
// memory port dates them. Source: Hakura and Gupta, ISCA 1997; Igehy, Eldridge and Proudfoot, "Prefetching in a texture cache
// architecture", 1998.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "channels/parameters.h"
#include "memory/texture_cache.h"
#include "units/counters.h"
#include "units/pipeline_context.h"
#include "units/tap_block.h"
#include "units/texture_layout.h"

namespace bump {

class AccessListener;

struct TextureFetchConfig {
  Filter filter = Filter::bilinear;
  int footprints_per_cycle = 2;
  CacheGeometry cache;

  /// Also declares what only the timing plane reads: latency, capacity and batch of the unit, and the memory port ("memory.*").
  static void declare(Parameters& parameters);
  /// Parameters that decide nothing but which look-ups hit and how long they take: what is read does not depend on them, and whoever knows
  /// that can tell the rest (sc_models/retiming).
  static std::vector<std::string> look_up_keys();
  TextureFetchConfig() = default;
  /// Throws Error(input) if the cache geometry is not a power of two where it must be.
  explicit TextureFetchConfig(const Configuration& configuration);
};

class TextureFetch {
 public:
  /// Encodes the bump maps of all objects, and makes those that belong to one surface (BumpEncoding::bake). Throws Error(input) if an
  /// object cannot have such a map, or if a map in object space meets vectors in another.
  TextureFetch(std::shared_ptr<const PipelineContext> context, const TextureFetchConfig& config);
  void process(FragmentBlock& block);
  /// Tells the listener of the textures in memory now, and of all reads that follow. It must outlive this.
  void listen(AccessListener& listener);

  /// Where a texture lies that follows others which end at `base`. Throws Error(input) if it is too large for the texture unit.
  static TextureLayout layout_of(const Texture& texture, std::uint64_t base, int line_bytes);

  const TextureCounters& counters() const { return counters_; }

 private:
  /// A texture in memory. `exact` is the same without rounding, null where nobody needs it.
  struct Resident {
    std::shared_ptr<const Texture> hardware, exact;
    TextureLayout layout;
  };
  struct ObjectTextures {
    int colour = 0, map = 0;                 ///< index into residents_; map: only if has_map_
    glm::dvec2 map_origin{0}, map_scale{1};  ///< coordinates of the bump map: (uv - origin) * scale, where a map spans several repeats
  };

  int place(std::shared_ptr<const Texture> hardware, std::shared_ptr<const Texture> exact);
  /// Encodes normals and places the map.
  int place_map(const Texture& normals, const BumpEncoding& encoding);
  /// Texels of one texture for all fragments of a block, into the planes from `plane` on; the taps stay for look_up().
  void fetch(const Resident& texture, const AccessLanes& at, FragmentBlock& block, int plane, TapBlock& taps);
  /// Where the bump map of one surface is read.
  AccessLanes scaled(const ObjectTextures& textures, const AccessLanes& at, int lanes);
  /// Looks the lines of a fragment up, in the order of its taps. Returns how many there are; adds its misses to `misses`.
  std::size_t look_up(const Resident& texture, const TapBlock& taps, std::size_t lane, int& misses);
  /// Looks the lines of all fragments up and leaves their records.
  void look_up(const std::array<const Resident*, 2>& textures, FragmentBlock& block);

  std::shared_ptr<const PipelineContext> context_;
  TextureFetchConfig config_;
  TextureCache cache_;
  TextureCounters counters_;
  AccessListener* listener_ = nullptr;
  std::vector<Resident> residents_;
  std::vector<ObjectTextures> objects_;   ///< one per scene object
  int colour_plane_ = 0, map_plane_ = 0;  ///< first of the texel planes
  bool has_map_ = true;                   ///< false: the scheme reads no bump map
  std::array<TapBlock, 2> taps_;          ///< of colour and bump map
  std::array<Lanes, 6> scaled_{};         ///< coordinates and derivatives of a map that spans several repeats
  TapBlock::Lines changed_{};             ///< not 0 where a fragment reads other lines than the one before
};

}  // namespace bump
