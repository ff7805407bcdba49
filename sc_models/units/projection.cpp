#include "units/projection.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace bump {

glm::dmat4 world_to_eye(const Camera& camera) {
  return glm::lookAtRH(camera.eye, camera.target, camera.up);
}

glm::dmat4 world_to_clip(const Camera& camera, int width, int height, double far) {
  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  const glm::dmat4 projection = glm::perspectiveRH_NO(glm::radians(camera.field_of_view), aspect, camera.near, far);
  return projection * world_to_eye(camera);
}

double far_distance(const Scene& scene) {
  double farthest = 0;
  for (const SceneObject& object : scene.objects) {
    if (!object.mesh) continue;
    for (const Vertex& vertex : object.mesh->vertices) {
      const glm::dvec3 world{object.to_world * glm::dvec4{vertex.position, 1.0}};
      farthest = std::max(farthest, glm::length(world - scene.camera.eye));
    }
  }
  return std::max(1.01 * farthest, 2 * scene.camera.near);
}

ScreenPosition to_screen(const glm::dvec4& clip, int width, int height) {
  const double inverse_w = 1 / clip.w;
  return {(clip.x * inverse_w * 0.5 + 0.5) * width, (0.5 - clip.y * inverse_w * 0.5) * height, (clip.z * inverse_w + 1) * 0.5, inverse_w};
}

}  // namespace bump
