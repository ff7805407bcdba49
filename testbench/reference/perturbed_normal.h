#pragma once
// The perturbed normal N' of a point in object space, in double precision: from the normal map in an exact frame (what every scheme with
// that map tries to reach), or from the height map by Blinn's perturbation (what the "conventional method" of Lee 2007 computes). Untimed.
//
// Units of Blinn's B: a height map is in texels of its own level 0. One texel is taken as the object's mean texel size
//   s = sqrt(area of the mesh in object space / area of its texture coordinates in texels),
// so that B(u, v) = s * h(u, v) is a length in object space. On a square, evenly mapped patch Pu and Pv then span s texels each and Blinn's
// normal is (-dh/dx, -dh/dy, 1) normalised: the square-patch normal map of the same heights. Elsewhere the two differ, as they should.

#include <glm/glm.hpp>

#include "testbench/reference/texture_footprint.h"
#include "units/scene.h"

namespace bump {

/// A shading point, everything interpolated perspective-correctly and not yet normalised.
struct SurfacePoint {
  glm::dvec3 normal{0, 0, 1}, tangent{1, 0, 0};
  double handedness = 1;
  glm::dvec2 uv{0};
  PixelFootprint footprint{0};  ///< used by the trilinear filter only
};

/// The orthonormal frame at a point: N, then T by Gram-Schmidt, then B = handedness * cross(N, T). Columns T, B, N.
glm::dmat3 exact_frame(const SurfacePoint& point);

/// Unit N' from the object's normal map; the unit N where the object has none.
glm::dvec3 normal_from_map(const SceneObject& object, const SurfacePoint& point, Filter filter);

/// Pu and Pv of a flat triangle: how its position changes with u and v. Object units per whole texture.
struct PositionDerivatives {
  glm::dvec3 along_u{0}, along_v{0};
  bool valid = false;  ///< false when the texture coordinates span no area
};
PositionDerivatives position_derivatives(const Vertex& a, const Vertex& b, const Vertex& c);

/// s as above, in object units; 0 when the object has no height map or its texture coordinates span no area.
double mean_texel_size(const SceneObject& object);

/// Unit N' by Lee 2007, Eq 1 (Blinn 1978): N' = N + Bu (N x Pv) - Bv (N x Pu) with N = Pu x Pv, where the direction of N is the smooth
/// interpolated normal and its length that of the patch projected along it. Slopes are central differences one texel to each side of the
/// filtered height map, of the level that the filter reads. Mirrored texture coordinates are handled. The unit N without heights.
glm::dvec3 normal_from_heights(const SceneObject& object, double texel_size, const PositionDerivatives& derivatives,
                               const SurfacePoint& point, Filter filter);

}  // namespace bump
