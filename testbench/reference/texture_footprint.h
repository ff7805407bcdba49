#pragma once
// How a pixel of the reference picture maps onto a texture, and the mip level that a trilinear access reads there. Written apart from the
// texture unit's arithmetic (memory/level_of_detail.h), which it judges. Untimed. Source: OpenGL specification, scale factor rho.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "memory/texture.h"

namespace bump {

/// Columns: the change of (u, v), in whole textures, over one pixel to the right and over one pixel down.
using PixelFootprint = glm::dmat2;

/// Level of detail of an access: log2 of the longer side of the footprint in texels of level 0, and 0 (level 0) where the side is no more
/// than a texel or the filter reads no other level.
inline double reference_level(const Texture& texture, Filter filter, const PixelFootprint& footprint) {
  if (filter != Filter::trilinear) return 0;
  const glm::dvec2 size{texture.levels[0].width, texture.levels[0].height};
  const double right = glm::length(size * footprint[0]), down = glm::length(size * footprint[1]);
  const double longer = std::max(right, down);
  return longer > 1 ? std::log2(longer) : 0;
}

}  // namespace bump
