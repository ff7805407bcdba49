#include "testbench/experiments/table2_scenes.h"

#include <cmath>

#include "datapath/error.h"
#include "datapath/invariant.h"
#include "units/projection.h"

namespace bump {

namespace {

/// The part of `vector` across the unit vector `along`, unit; zero if there is none.
glm::dvec3 across(const glm::dvec3& vector, const glm::dvec3& along) {
  const glm::dvec3 part = vector - along * glm::dot(vector, along);
  const double length = glm::length(part);
  return length > 1e-9 * glm::length(vector) ? part / length : glm::dvec3(0);
}

}  // namespace

Scene arrange_table2_scene(const Scene& shipped, const Table2Light& at) {
  BUMP_ASSERT(!shipped.objects.empty());
  Scene scene = shipped;
  const glm::dvec3 centre{scene.objects.front().to_world[3]};
  const glm::dvec3 to_eye = scene.camera.eye - centre;
  const double distance = glm::length(to_eye);
  if (!(distance > 0))
    throw Error({"the eye of scene \"" + scene.name + "\" stands in the centre of its object",
                 {},
                 "table2 measures the angle of the light from there",
                 "another camera"});
  const glm::dvec3 towards_eye = to_eye / distance;
  // The camera's axes, but about the line from the object's centre to the eye: the camera need not look exactly there.
  const glm::dmat3 to_camera{world_to_eye(scene.camera)};
  const glm::dvec3 camera_right = glm::transpose(to_camera)[0], camera_up = glm::transpose(to_camera)[1];
  glm::dvec3 right = across(camera_right, towards_eye);
  if (right == glm::dvec3(0)) right = across(camera_up, towards_eye);
  const glm::dvec3 up = glm::cross(towards_eye, right);
  const double angle = glm::radians(at.degrees), azimuth = glm::radians(at.azimuth);
  Light light;
  light.directional = false;
  light.vector =
      centre + distance * (std::cos(angle) * towards_eye + std::sin(angle) * (std::cos(azimuth) * right + std::sin(azimuth) * up));
  scene.lights = {light};
  for (SceneObject& object : scene.objects) object.material = table2_material;
  return scene;
}

}  // namespace bump
