#pragma once
// What the units of the functional plane count while they compute values. No time: cycles are the timing plane's.

#include <cstdint>
#include <limits>
#include <string>

namespace bump {

struct TextureCounters {
  std::int64_t reads = 0;                           ///< texels
  std::int64_t accesses = 0, hits = 0, misses = 0;  ///< cache lines looked up
  std::int64_t bytes = 0;                           ///< moved from memory
};

/// Of one light map, all objects together.
struct LightMapCounters {
  std::int64_t reads = 0, hits = 0, misses = 0;  ///< words, each of which is one look-up of the cache
  std::int64_t bytes = 0;                        ///< moved from memory
  std::int64_t clipped = 0;                      ///< reads of words that the map's format had cut off
};

struct GeometryCounters {
  std::int64_t vertices = 0;           ///< transformed
  std::int64_t vertex_reuses = 0;      ///< found in the post-transform cache
  std::int64_t triangles = 0;          ///< that entered
  std::int64_t triangles_clipped = 0;  ///< cut by the near plane or the guard band; counted below as well

  // What became of each mesh triangle, whatever it was cut into: triangles = culled + empty + hidden + drawn.
  std::int64_t triangles_culled = 0;  ///< dropped for facing away
  std::int64_t triangles_empty = 0;   ///< beside the frame, edge-on, or covering no pixel centre
  std::int64_t triangles_hidden = 0;  ///< covering pixel centres, all of them killed by early z; none without early z
  std::int64_t triangles_drawn = 0;   ///< with at least one fragment

  std::int64_t fragments_generated = 0, fragments_hidden = 0, fragments = 0;  ///< covered, killed by early z, shaded
  std::int64_t fragments_retired = 0;                                         ///< arrived in the frame sink
};

/// NaN, for not applicable, where nothing was counted.
struct AngularError {
  std::string vector;      ///< "L'", "H'"
  std::int64_t count = 0;  ///< vectors that light the surface
  double mean_degrees = std::numeric_limits<double>::quiet_NaN(), rms_degrees = mean_degrees, max_degrees = mean_degrees;
};

}  // namespace bump
