#include "testbench/experiments/tangent_fit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace bump {

namespace {

constexpr double degrees_of_radian = 57.29577951308232;
/// Of the sine of the angle between N and the z axis: nearer, e_phi is taken from T.
constexpr double on_axis = 1e-6;

double degrees_off(const glm::dvec3& normal, const glm::dvec3& tangent, Tangents assumed) {
  const double from_axis = std::hypot(normal.x, normal.y);
  if (from_axis < on_axis) return 0;
  const glm::dvec3 parallel(-normal.y / from_axis, normal.x / from_axis, 0);
  const glm::dvec3 wanted = assumed == Tangents::parallels ? parallel : glm::cross(parallel, normal);
  const double cosine = std::clamp(glm::dot(tangent, wanted), -1.0, 1.0);
  return std::acos(assumed == Tangents::downwards ? cosine : std::abs(cosine)) * degrees_of_radian;
}

bool is_word(const Configuration& configuration, const std::string& key, const char* word) {
  const Parameter* parameter = configuration.parameters().find(key);
  return parameter != nullptr && std::holds_alternative<std::string>(parameter->fallback) && configuration.choice(key) == word;
}

}  // namespace

std::optional<Tangents> assumed_tangents(const SchemePage& page, const Configuration& configuration) {
  if (is_word(configuration, page.id + ".normal", "matrix")) return std::nullopt;
  const std::string key = page.id + ".frame";
  if (is_word(configuration, key, "parallel")) return Tangents::parallels;
  if (is_word(configuration, key, "meridian")) return Tangents::meridians;
  if (is_word(configuration, key, "none")) return Tangents::downwards;
  return std::nullopt;
}

TangentFit tangent_fit(const SceneObject& object, const ObjectSpace& space, Tangents assumed) {
  double area = 0, sum = 0, off = 0;
  for (const glm::uvec3& triangle : object.mesh->triangles) {
    const Vertex* corners[] = {&object.mesh->vertices[triangle.x], &object.mesh->vertices[triangle.y], &object.mesh->vertices[triangle.z]};
    const double share =
        glm::length(glm::cross(corners[1]->position - corners[0]->position, corners[2]->position - corners[0]->position)) / 3;
    for (const Vertex* corner : corners) {
      const double degrees = degrees_off(space.direction(corner->normal), space.direction(corner->tangent), assumed);
      area += share;
      sum += share * degrees;
      if (degrees > TangentFit::off_degrees) off += share;
    }
  }
  return area > 0 ? TangentFit{sum / area, off / area} : TangentFit{};
}

}  // namespace bump
