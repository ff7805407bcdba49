#pragma once
// The image that leaves the pipeline, and that the reference renderer draws: values, no hardware. Colour is kept unrounded, so that
// quality can be measured below one 8-bit step; object and depth tell which pixels of two frames show the same surface.

#include <cstdint>
#include <vector>

namespace bump {

/// A frame in double precision, row 0 on top, three channels interleaved, display values in [0, 1].
struct FrameBuffer {
  int width = 0, height = 0;
  std::vector<double> colour;
  std::vector<std::int32_t> object;  ///< index into Scene::objects, -1 for background
  std::vector<double> depth;         ///< z / w in [0, 1]; 1 for background
};

}  // namespace bump
