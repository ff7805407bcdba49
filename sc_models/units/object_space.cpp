#include "units/object_space.h"

#include "units/projection.h"

namespace bump {

glm::dvec3 ObjectSpace::position(const glm::dvec3& in_object) const {
  return shading == ShadingSpace::object ? in_object : glm::dvec3(to_shading * glm::dvec4(in_object, 1.0));
}

glm::dvec3 ObjectSpace::direction(const glm::dvec3& in_object) const {
  return shading == ShadingSpace::object ? in_object : rotation * in_object;
}

glm::dvec3 ObjectSpace::light_vector(int light, const glm::dvec3& from) const {
  const Light& source = lights[static_cast<std::size_t>(light)];
  return source.directional ? source.vector : source.vector - position(from);
}

glm::dvec3 ObjectSpace::eye_vector(const glm::dvec3& from) const {
  return eye - position(from);
}

ObjectSpace make_object_space(const Scene& scene, const SceneObject& object, const glm::dmat4& to_clip_from_world, ShadingSpace shading) {
  ObjectSpace space;
  space.shading = shading;
  space.to_clip = to_clip_from_world * object.to_world;
  glm::dmat4 from_world = glm::inverse(object.to_world);
  if (shading == ShadingSpace::eye) {
    from_world = world_to_eye(scene.camera);
    space.to_shading = from_world * object.to_world;
    for (int column = 0; column < 3; ++column) space.rotation[column] = glm::normalize(glm::dvec3(space.to_shading[column]));
  } else {
    space.eye = glm::dvec3(from_world * glm::dvec4(scene.camera.eye, 1.0));
  }
  for (Light light : scene.lights) {
    const glm::dvec4 moved = from_world * glm::dvec4(light.vector, light.directional ? 0.0 : 1.0);
    light.vector = light.directional ? glm::normalize(glm::dvec3(moved)) : glm::dvec3(moved);
    space.lights.push_back(light);
  }
  return space;
}

}  // namespace bump
