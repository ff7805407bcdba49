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
#include "memory/level_of_detail.h"
#include "memory/texture_cache.h"
#include "units/bilinear_footprint.h"
#include "units/counters.h"
#include "units/pipeline_context.h"
#include "units/texture_layout.h"

namespace bump {

struct TextureFetchConfig {
  Filter filter = Filter::bilinear;
  int footprints_per_cycle = 2;
  CacheGeometry cache;

  /// Also declares what only the timing plane reads: latency, capacity and batch of the unit, and the memory port ("memory.*").
  static void declare(Parameters& parameters);
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

  /// Where a texture is read.
  struct Access {
    double u, v;
    TextureDerivatives derivatives;
  };

  int place(std::shared_ptr<const Texture> hardware, std::shared_ptr<const Texture> exact);
  /// Encodes normals and places the map.
  int place_map(const Texture& normals, const BumpEncoding& encoding);
  /// Texels of one texture for one fragment, into the planes from `plane` on.
  void fetch(const Resident& texture, const Access& access, FragmentBlock& block, std::size_t lane, int plane);
  void fetch_footprint(const Resident& texture, const BilinearFootprint& footprint, FragmentBlock& block, std::size_t lane, int plane);
  void look_up(std::uint64_t address);

  std::shared_ptr<const PipelineContext> context_;
  TextureFetchConfig config_;
  TextureCache cache_;
  TextureCounters counters_;
  std::vector<Resident> residents_;
  std::vector<ObjectTextures> objects_;    ///< one per scene object
  int colour_plane_ = 0, map_plane_ = 0;   ///< first of the texel planes
  bool has_map_ = true;                    ///< false: the scheme reads no bump map
  std::array<std::uint64_t, 16> lines_{};  ///< distinct lines of the fragment so far: two textures, eight texels each
  std::size_t line_count_ = 0;
  std::vector<double> texel_;        ///< channels of one texture, for the general way
  int footprints_ = 0, misses_ = 0;  ///< of the fragment so far
};

}  // namespace bump
