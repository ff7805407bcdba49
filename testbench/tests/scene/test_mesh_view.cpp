#include <cmath>
#include <sstream>

#include "scene_bench.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/shapes.h"

using namespace bump;
using namespace bump::test;

namespace {

/// Of the projected area of a scene's triangles, the part that faces the camera, 0 to 1.
double facing_part(const Scene& scene) {
  double towards = 0, all = 0;
  const glm::dvec3 view = scene.camera.eye - scene.camera.target;
  for (const auto& object : scene.objects) {
    for (const auto& triangle : object.mesh->triangles) {
      const auto corner = [&](int i) { return object.mesh->vertices[triangle[i]].position; };
      const double area = glm::dot(glm::cross(corner(1) - corner(0), corner(2) - corner(0)), view);
      towards += std::max(area, 0.0);
      all += std::abs(area);
    }
  }
  return towards / all;
}

std::string obj_text(const Mesh& mesh, bool inside_out) {
  std::ostringstream text;
  for (const auto& v : mesh.vertices) text << "v " << v.position.x << " " << v.position.y << " " << v.position.z << "\n";
  for (const auto& t : mesh.triangles) {
    text << "f " << t.x + 1 << " " << (inside_out ? t.z : t.y) + 1 << " " << (inside_out ? t.y : t.z) + 1 << "\n";
  }
  return text.str();
}

}  // namespace

TEST_CASE("a mesh wound clockwise is seen, and lit, from behind") {
  const TemporaryFolder folder;
  const std::string corners = "v 0 0 0\nv 0 1 0\nv 1 0 0\n";
  const Scene front = read_scene(folder.write("front.obj", corners + "f 1 3 2\n"));
  const Scene behind = read_scene(folder.write("behind.obj", corners + "f 1 2 3\n"));
  CHECK(facing_part(front) == 1);
  CHECK(facing_part(behind) == 1);
  CHECK_FALSE(warns_of(front.warnings, "turns its back"));
  CHECK(warns_of(behind.warnings, "'behind.obj': most of the mesh turns its back"));
  const glm::dvec3 turned(-1, 1, -1), eye = front.camera.eye - front.camera.target;
  CHECK(glm::distance(behind.camera.eye - behind.camera.target, eye * turned) < 1e-12);
  CHECK(behind.lights[0].vector == front.lights[0].vector * turned);
  CHECK(behind.camera.near == front.camera.near);
}

TEST_CASE("a flat mesh of any direction faces the camera and the light that it is given") {
  const TemporaryFolder folder;
  int turned = 0;
  for (int i = 0; i < 60; ++i) {  // normals all around, the axes first
    const double z = 1 - (i + 0.5) / 30, radius = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    glm::dvec3 normal(radius * std::cos(angle), radius * std::sin(angle), z);
    if (i < 6) {
      normal = glm::dvec3(0);
      normal[i / 2] = i % 2 == 0 ? 1 : -1;
    }
    const glm::dvec3 a = glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 b = glm::cross(normal, a);
    std::ostringstream text;
    text.precision(17);
    for (const glm::dvec3& p : {a, b, -a, -b}) text << "v " << p.x << " " << p.y << " " << p.z << "\n";
    const Scene scene = read_scene(folder.write("plane.obj", text.str() + "f 1 2 3 4\n"));
    CHECK(facing_part(scene) == 1);
    turned += warns_of(scene.warnings, "turns its back") ? 1 : 0;
  }
  CHECK(turned > 20);
  CHECK(turned < 40);
}

TEST_CASE("a closed mesh, even one inside out, and one with a small hole, are seen from the front") {
  const TemporaryFolder folder;
  Mesh sphere = make_sphere(2, 24, 12);
  for (const bool inside_out : {false, true}) {
    const Scene scene = read_scene(folder.write("ball.obj", obj_text(sphere, inside_out)));
    CHECK(scene.camera.eye.z > 0);
    CHECK_FALSE(warns_of(scene.warnings, "turns its back"));
  }
  // The hole is where the camera looks at the sphere.
  std::size_t nearest = 0;
  double most = -1;
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    const double along = glm::dot(sphere.vertices[sphere.triangles[i].x].position, glm::dvec3(0.35, 0.3, 1));
    if (along > most) {
      most = along;
      nearest = i;
    }
  }
  sphere.triangles.erase(sphere.triangles.begin() + static_cast<std::ptrdiff_t>(nearest));
  const Scene scene = read_scene(folder.write("hole.obj", obj_text(sphere, false)));
  CHECK(scene.camera.eye.z > 0);
  CHECK(facing_part(scene) < 0.5);
}
