#pragma once
// The level of detail that the texture unit of the simulated hardware derives from a fragment's texture-coordinate derivatives, for each
// texture of its own, since it depends on the texture's size. Isotropic: the longer of the two axes of the pixel's footprint decides. It
// takes part of the texture stage's latency. The reference renderer has a formula of its own. Source: OpenGL specification, the scale
// factor rho = max(|(du/dx W, dv/dx H)|, |(du/dy W, dv/dy H)|).

#include <algorithm>
#include <cmath>

#include "memory/texture.h"

namespace bump {

/// Level of detail of a fragment on which nothing changes from pixel to pixel: finer than any texture.
constexpr double finest_level_of_detail = -64;

/// How (u, v) changes over one pixel to the right (x) and one pixel down (y), in units of the whole texture.
struct TextureDerivatives {
  double dudx = 0, dvdx = 0, dudy = 0, dvdy = 0;
};

/// log2 rho, rho in texels of level 0 per pixel, for a texture of width x height texels. Never below finest_level_of_detail, also where
/// derivatives are not numbers.
inline double level_of_detail(const TextureDerivatives& d, int width, int height) {
  const double w = width, h = height;
  const double across = (d.dudx * w) * (d.dudx * w) + (d.dvdx * h) * (d.dvdx * h);
  const double down = (d.dudy * w) * (d.dudy * w) + (d.dvdy * h) * (d.dvdy * h);
  const double squared = std::max(across, down);
  if (!(squared > 0)) return finest_level_of_detail;
  return std::max(0.5 * std::log2(squared), finest_level_of_detail);
}

/// What the texture unit hands to texel_taps(). Only the trilinear filter reads coarser levels; nearest and bilinear stay on level 0.
inline double lod_of_access(const Texture& texture, Filter filter, const TextureDerivatives& derivatives) {
  if (filter != Filter::trilinear) return 0;
  return level_of_detail(derivatives, texture.levels[0].width, texture.levels[0].height);
}

}  // namespace bump
