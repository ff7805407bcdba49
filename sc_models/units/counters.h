#pragma once
// What the units of the functional plane count while they compute values. No time: cycles are the timing plane's.

#include <cstdint>
#include <string>

namespace bump {

struct TextureCounters {
  std::int64_t reads = 0;                           ///< texels
  std::int64_t accesses = 0, hits = 0, misses = 0;  ///< cache lines looked up
  std::int64_t bytes = 0;                           ///< moved from memory
};

struct GeometryCounters {
  std::int64_t vertices = 0;       ///< transformed
  std::int64_t vertex_reuses = 0;  ///< found in the post-transform cache
  std::int64_t triangles = 0;      ///< that entered
  std::int64_t triangles_clipped = 0, triangles_culled = 0, triangles_empty = 0;
  std::int64_t fragments_generated = 0, fragments_hidden = 0, fragments = 0;  ///< covered, killed by early z, shaded
  std::int64_t fragments_retired = 0;                                         ///< arrived in the frame sink
};

struct AngularError {
  std::string vector;  ///< "L'", "H'"
  std::int64_t count = 0;
  double mean_degrees = 0, rms_degrees = 0, max_degrees = 0;
};

}  // namespace bump
