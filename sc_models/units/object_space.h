#pragma once
// The scene as seen from one object: lights and eye in its own coordinates, where all shading takes place, and its clip transform. Set up
// once a frame by the host, so it costs neither time nor operators in the models.

#include <glm/glm.hpp>
#include <vector>

#include "units/scene.h"

namespace bump {

struct ObjectSpace {
  glm::dmat4 to_clip{1};      ///< object to clip coordinates
  glm::dvec3 eye{0};          ///< object coordinates
  std::vector<Light> lights;  ///< object coordinates; directions are unit vectors

  /// Towards light `light` from `position` (object coordinates): unit for a directional light, else the difference.
  glm::dvec3 light_vector(int light, const glm::dvec3& position) const;
  /// Towards the eye from `position`: the difference.
  glm::dvec3 eye_vector(const glm::dvec3& position) const { return eye - position; }
};

/// to_world of the object must be a rotation, translation and uniform scale (scene.h).
ObjectSpace make_object_space(const Scene& scene, const SceneObject& object, const glm::dmat4& to_clip_from_world);

}  // namespace bump
