#include "units/object_space.h"

namespace bump {

glm::dvec3 ObjectSpace::light_vector(int light, const glm::dvec3& position) const {
  const Light& source = lights[static_cast<std::size_t>(light)];
  return source.directional ? source.vector : source.vector - position;
}

ObjectSpace make_object_space(const Scene& scene, const SceneObject& object, const glm::dmat4& to_clip_from_world) {
  ObjectSpace space;
  const glm::dmat4 to_object = glm::inverse(object.to_world);
  space.to_clip = to_clip_from_world * object.to_world;
  space.eye = glm::dvec3(to_object * glm::dvec4(scene.camera.eye, 1.0));
  for (Light light : scene.lights) {
    const glm::dvec4 moved = to_object * glm::dvec4(light.vector, light.directional ? 0.0 : 1.0);
    light.vector = light.directional ? glm::normalize(glm::dvec3(moved)) : glm::dvec3(moved);
    space.lights.push_back(light);
  }
  return space;
}

}  // namespace bump
