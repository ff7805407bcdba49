#pragma once
// The level of detail that the texture unit derives from a fragment's texture-coordinate derivatives. One definition for the simulated
// hardware and the reference renderer. Isotropic: the larger of the two footprint axes decides. It takes part of the texture stage's
// latency. Source: OpenGL specification, the scale factor rho.

#include <algorithm>
#include <cmath>

#include "memory/texture.h"

namespace bump {

/// Level of detail of a fragment on whom nothing changes from pixel to pixel: finer than any texture.
constexpr double finest_level_of_detail = -64;

/// log2 of the larger change of (u, v) over one pixel to the right (dudx, dvdx) and one pixel down (dudy, dvdy), in units of the whole
/// texture: the `lod` that a fragment carries, log2 of texels per pixel for a 1 x 1 texture.
/// Never below finest_level_of_detail; NaN never.
inline double level_of_detail(double dudx, double dvdx, double dudy, double dvdy) {
  const double across = dudx * dudx + dvdx * dvdx, down = dudy * dudy + dvdy * dvdy;
  const double squared = std::max(across, down);
  if (!(squared > 0)) return finest_level_of_detail;
  return std::max(0.5 * std::log2(squared), finest_level_of_detail);
}

/// What the texture unit hands to texel_taps() for a fragment's `lod`: log2 of texels per pixel of level 0 of this texture. Only the
/// trilinear filter reads coarser levels; nearest and bilinear stay on level 0.
inline double lod_of_access(const Texture& texture, Filter filter, double lod) {
  if (filter != Filter::trilinear) return 0;
  return lod + std::log2(static_cast<double>(std::max(texture.levels[0].width, texture.levels[0].height)));
}

}  // namespace bump
