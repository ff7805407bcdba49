#pragma once
// Bump maps that belong to one surface: a normal for every texel from the surface point under it, over all repeats of the texture that the
// object uses. Preprocessing by the host: no hardware, no time. Coarser levels are averages made unit again, as for maps in tangent space.
// Source: Peercy, Airey and Cabral 1997, Eqs 3-6 (tangent space) and section 2.1 (object space); what a texel holds is the caller's.

#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "units/texture_chart.h"

namespace bump {

/// Normals for the texture unit, and where they lie: texture coordinates of the map are (uv - uv_origin) * uv_scale.
struct SurfaceMap {
  Texture normals;  ///< 3 channels, unit
  glm::dvec2 uv_origin{0}, uv_scale{1};
};

/// Unit N' for the surface under a texel, in the space of the map.
using SurfaceNormal = std::function<glm::dvec3(const SurfaceTexel&)>;

/// `texture` gives texels per repeat, wrap modes and name. A texel may lie on several surface points if N' is the same for all, within
/// 1/128. Throws Error(input) with `remedy` as its advice: see TextureChart.
SurfaceMap bake_surface_map(const SceneObject& object, const Texture& texture, const SurfaceNormal& normal, const std::string& remedy);

/// Side of a texel of the height map on the object's surface, on average: sqrt(area in object space / area in texels). Heights in texels
/// times this are lengths in object space. 0 if the texture coordinates span no area.
double mean_texel_side(const SceneObject& object, const Texture& heights);

}  // namespace bump
