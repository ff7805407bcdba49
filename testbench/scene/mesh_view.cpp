#include "testbench/scene/mesh_view.h"

#include <algorithm>
#include <cmath>

namespace bump {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A place for camera and light: the signs of x, y and z against the usual one. Two of them change, which is half a turn. Whatever plane
/// faces away in one of the four places faces the camera in another, since their four directions add up to zero.
struct Side {
  const char* name;
  glm::dvec3 signs;
};
constexpr std::size_t side_count = 4;

const Side& side(std::size_t index) {
  static const Side sides[side_count] = {
      {"in front", {1, 1, 1}}, {"behind", {-1, 1, -1}}, {"behind and below", {1, -1, -1}}, {"in front and below", {-1, -1, 1}}};
  return sides[index];
}

/// Twice the area projected along a direction: of triangles that face it and of those that face away.
struct ProjectedArea {
  double towards = 0, away = 0;
};

ProjectedArea projected_area(const Scene& scene, const glm::dvec3& direction, double radius) {
  ProjectedArea area;
  for (const auto& object : scene.objects) {
    for (const auto& triangle : object.mesh->triangles) {
      const auto corner = [&](int i) { return object.mesh->vertices[triangle[i]].position / radius; };
      const double facing = glm::dot(glm::cross(corner(1) - corner(0), corner(2) - corner(0)), direction);
      (facing > 0 ? area.towards : area.away) += std::abs(facing);
    }
  }
  return area;
}

/// Index of the side from which the mesh is seen.
std::size_t choose_side(const Scene& scene, const glm::dvec3& direction, double radius) {
  const ProjectedArea front = projected_area(scene, direction, radius);
  if (front.away <= 1.1 * front.towards) return 0;
  std::size_t best = 0;
  double most = front.towards - front.away;
  for (std::size_t i = 1; i < side_count; ++i) {
    const ProjectedArea area = projected_area(scene, direction * side(i).signs, radius);
    if (area.towards - area.away > most) {
      most = area.towards - area.away;
      best = i;
    }
  }
  return best;
}

}  // namespace

void place_view(const std::string& mesh, Scene& scene) {
  glm::dvec3 low(scene.objects[0].mesh->vertices[0].position), high = low;
  for (const auto& object : scene.objects) {
    for (const auto& vertex : object.mesh->vertices) {
      low = glm::min(low, vertex.position);
      high = glm::max(high, vertex.position);
    }
  }
  scene.camera.target = 0.5 * (low + high);
  double radius = 0;
  for (const auto& object : scene.objects) {
    for (const auto& vertex : object.mesh->vertices) radius = std::max(radius, glm::distance(vertex.position, scene.camera.target));
  }
  const glm::dvec3 usual = glm::normalize(glm::dvec3(0.35, 0.3, 1));
  const std::size_t chosen = choose_side(scene, usual, radius);
  if (chosen > 0) {
    scene.warnings.push_back("'" + mesh + "': most of the mesh turns its back to a camera in front of it, which would not see it (is it " +
                             "wound clockwise?); camera and light are placed " + side(chosen).name);
  }
  scene.camera.field_of_view = 35;
  const double distance = radius / std::sin(0.5 * scene.camera.field_of_view * pi / 180);
  scene.camera.eye = scene.camera.target + distance * (usual * side(chosen).signs);
  scene.camera.up = glm::dvec3(0, 1, 0);
  scene.camera.near = 0.01 * radius;
  Light light;
  light.vector = glm::normalize(glm::dvec3(-0.5, 0.7, 0.75)) * side(chosen).signs;
  scene.lights = {light};
}

}  // namespace bump
