#pragma once
// How far the tangents of a mesh are from those that a scheme takes for granted. Some schemes read their bump map as if T ran along the
// parallels, or the meridians, of the z axis of the shading axes; the relief of a chart whose tangents run elsewhere appears turned about N
// by the angle between. Found from the vertices alone, with the object's pose where shading is along the camera's axes; no picture is
// drawn. Left out: what interpolation adds between vertices, and how steep the relief is, so that an angle is no number of decibels.

#include <optional>

#include "channels/parameters.h"
#include "schemes/scheme.h"
#include "units/object_space.h"
#include "units/scene.h"

namespace bump {

enum class Tangents {
  parallels,  ///< T or -T along e_phi of N
  meridians,  ///< T or -T along e_theta of N
  downwards   ///< T along e_theta of N, which points away from the pole
};

/// What the scheme assumes under the configuration, by its parameter `<id>.frame`: `parallel`, `meridian`, or `none`, which leaves the map
/// unturned. Missing if it has no such parameter, if the value turns every texel, or if it interpolates T itself (`<id>.normal = matrix`).
std::optional<Tangents> assumed_tangents(const SchemePage& page, const Configuration& configuration);

struct TangentFit {
  double mean_degrees = 0;  ///< over the surface
  double off_share = 0;     ///< of the surface, 0 to 1: where it is more than `off_degrees`
  static constexpr double off_degrees = 5;
};

/// Along the axes of `space`. Where N is on the z axis any T will do, as it does for the schemes.
TangentFit tangent_fit(const SceneObject& object, const ObjectSpace& space, Tangents assumed);

}  // namespace bump
