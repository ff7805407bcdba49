#pragma once
// The scene as seen from one object: lights and eye in the axes in which its vectors are shaded, and its clip transform. The axes are the
// object's own (Lee 2007 and its predecessors light in object space) or those of the camera: x to the right, y up, z towards the viewer.
// Schemes on polar angles have their pole on the z axis, so for them the choice is one of method; Cartesian ones only turn. Set up once a
// frame by the host, so it costs neither time nor operators in the models; what a vertex pays is in vertex_processor.h.

#include <glm/glm.hpp>
#include <vector>

#include "units/scene.h"

namespace bump {

enum class ShadingSpace {
  object,  ///< the object's coordinates
  eye      ///< the camera's: the eye at the origin, lengths as in the world
};

struct ObjectSpace {
  glm::dmat4 to_clip{1};  ///< object to clip coordinates
  ShadingSpace shading = ShadingSpace::object;
  glm::dmat4 to_shading{1};   ///< object to shading coordinates: rotation, translation, uniform scale
  glm::dmat3 rotation{1};     ///< its rotation
  glm::dvec3 eye{0};          ///< shading coordinates
  std::vector<Light> lights;  ///< shading coordinates; directions are unit vectors

  /// A point of the object in shading coordinates. In object space, here and below, not a bit changes.
  glm::dvec3 position(const glm::dvec3& in_object) const;
  /// A vector of the object along the shading axes, of the same length.
  glm::dvec3 direction(const glm::dvec3& in_object) const;
  /// Towards light `light` from `position` (object coordinates), along the shading axes: unit for a directional light, else the difference.
  glm::dvec3 light_vector(int light, const glm::dvec3& position) const;
  /// Towards the eye from `position` (object coordinates), along the shading axes: the difference.
  glm::dvec3 eye_vector(const glm::dvec3& position) const;
};

/// to_world of the object must be a rotation, translation and uniform scale (scene.h).
ObjectSpace make_object_space(const Scene& scene, const SceneObject& object, const glm::dmat4& to_clip_from_world,
                              ShadingSpace shading = ShadingSpace::object);

}  // namespace bump
