#include "testbench/reference/perturbed_normal.h"

#include <algorithm>
#include <cmath>

#include "memory/texture.h"

namespace bump {

namespace {

/// Unit vector, or what `otherwise` gives where there is no direction to keep.
template <class Otherwise>
glm::dvec3 unit_or(const glm::dvec3& vector, const Otherwise& otherwise) {
  const double length = glm::length(vector);
  return length > 0 && std::isfinite(length) ? vector / length : otherwise();
}

glm::dvec3 unit(const glm::dvec3& vector, const glm::dvec3& otherwise) {
  return unit_or(vector, [&] { return otherwise; });
}

/// Any direction across `normal`, for tangents that vanish.
glm::dvec3 across(const glm::dvec3& normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
  return glm::normalize(axis - normal * glm::dot(normal, axis));
}

double height_at(const Texture& heights, Filter filter, double u, double v, double level) {
  double height = 0;
  sample(heights, filter, u, v, level, &height);
  return height;
}

/// Half the distance of a central difference, in texels of level 0: one texel of the level that a trilinear access reads.
double difference_step(const Texture& heights, double level) {
  if (level <= 0) return 1;
  return std::exp2(std::clamp(level, 0.0, static_cast<double>(heights.levels.size() - 1)));
}

}  // namespace

glm::dmat3 exact_frame(const SurfacePoint& point) {
  const glm::dvec3 normal = unit(point.normal, {0, 0, 1});
  const glm::dvec3 tangent = unit_or(point.tangent - normal * glm::dot(normal, point.tangent), [&] { return across(normal); });
  const glm::dvec3 binormal = glm::cross(normal, tangent) * (point.handedness < 0 ? -1.0 : 1.0);
  return {tangent, binormal, normal};
}

glm::dvec3 normal_from_map(const SceneObject& object, const SurfacePoint& point, Filter filter) {
  const glm::dmat3 frame = exact_frame(point);
  if (!object.normals) return frame[2];
  double texel[3] = {0, 0, 1};
  sample(*object.normals, filter, point.uv.x, point.uv.y, reference_level(*object.normals, filter, point.footprint), texel);
  const glm::dvec3 normal = unit({texel[0], texel[1], texel[2]}, {0, 0, 1});
  return glm::normalize(frame * normal);
}

PositionDerivatives position_derivatives(const Vertex& a, const Vertex& b, const Vertex& c) {
  const glm::dvec3 edge1 = b.position - a.position, edge2 = c.position - a.position;
  const glm::dvec2 uv1 = b.uv - a.uv, uv2 = c.uv - a.uv;
  const double area = uv1.x * uv2.y - uv2.x * uv1.y;
  if (area == 0 || !std::isfinite(1 / area)) return {};
  return {(edge1 * uv2.y - edge2 * uv1.y) / area, (edge2 * uv1.x - edge1 * uv2.x) / area, true};
}

double mean_texel_size(const SceneObject& object) {
  if (!object.heights || !object.mesh) return 0;
  double surface = 0, coordinates = 0;  // both twice the area: the factor cancels
  for (const glm::uvec3& corner : object.mesh->triangles) {
    const Vertex &a = object.mesh->vertices[corner.x], &b = object.mesh->vertices[corner.y], &c = object.mesh->vertices[corner.z];
    surface += glm::length(glm::cross(b.position - a.position, c.position - a.position));
    coordinates += std::abs((b.uv.x - a.uv.x) * (c.uv.y - a.uv.y) - (c.uv.x - a.uv.x) * (b.uv.y - a.uv.y));
  }
  const TextureLevel& level = object.heights->levels[0];
  const double texels = coordinates * level.width * level.height;
  return texels > 0 ? std::sqrt(surface / texels) : 0;
}

glm::dvec3 normal_from_heights(const SceneObject& object, double texel_size, const PositionDerivatives& derivatives,
                               const SurfacePoint& point, Filter filter) {
  const glm::dvec3 normal = unit(point.normal, {0, 0, 1});
  if (!object.heights || !derivatives.valid) return normal;
  const Texture& heights = *object.heights;
  const double width = heights.levels[0].width, height = heights.levels[0].height;
  const double level = reference_level(heights, filter, point.footprint);
  const double step = difference_step(heights, level);
  const double u = point.uv.x, v = point.uv.y;
  const double du = step / width, dv = step / height;
  // Change of B over the whole texture, in object units.
  const double bu = texel_size * (height_at(heights, filter, u + du, v, level) - height_at(heights, filter, u - du, v, level)) / (2 * du);
  const double bv = texel_size * (height_at(heights, filter, u, v + dv, level) - height_at(heights, filter, u, v - dv, level)) / (2 * dv);

  const glm::dvec3 &pu = derivatives.along_u, &pv = derivatives.along_v;
  // Negative where the texture is mirrored: Pu x Pv then points inside, and so would the result.
  const double patch = glm::dot(normal, glm::cross(pu, pv));
  const glm::dvec3 perturbed = normal * patch + glm::cross(normal, pv) * bu - glm::cross(normal, pu) * bv;
  return unit(patch < 0 ? -perturbed : perturbed, normal);
}

}  // namespace bump
