#include "units/surface_map.h"

#include <cmath>
#include <utility>

namespace bump {

SurfaceMap bake_surface_map(const SceneObject& object, const Texture& texture, const SurfaceNormal& normal, const std::string& remedy) {
  // The step of an 8-bit component.
  const auto agree = [&](const SurfaceTexel& a, const SurfaceTexel& b) { return glm::length(normal(a) - normal(b)) <= 1.0 / 128; };
  const TextureChart chart(object, texture, agree, remedy);
  SurfaceMap map;
  map.uv_origin = chart.origin();
  map.uv_scale = 1.0 / chart.repeats();
  Texture& normals = map.normals;
  normals.name = texture.name;
  normals.channels = 3;
  normals.kinds.assign(3, ChannelKind::linear);
  normals.wrap_u = chart.wrap_u();
  normals.wrap_v = chart.wrap_v();
  TextureLevel level{chart.width(), chart.height(), {}};
  level.texels.reserve(3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  for (int y = 0; y < level.height; ++y)
    for (int x = 0; x < level.width; ++x) {
      const glm::dvec3 n = normal(chart.at(x, y));
      level.texels.insert(level.texels.end(), {n.x, n.y, n.z});
    }
  normals.levels.push_back(std::move(level));
  build_mip_levels(normals);
  for (std::size_t l = 1; l < normals.levels.size(); ++l) {
    std::vector<double>& texels = normals.levels[l].texels;
    for (std::size_t i = 0; i < texels.size(); i += 3) {
      const glm::dvec3 sum{texels[i], texels[i + 1], texels[i + 2]};
      const double length = glm::length(sum);
      // Normals all round, as on the coarsest level of a sphere, have no mean direction.
      const glm::dvec3 mean = length > 1e-6 ? sum / length : glm::dvec3(0, 0, 1);
      for (int c = 0; c < 3; ++c) texels[i + static_cast<std::size_t>(c)] = mean[c];
    }
  }
  return map;
}

double mean_texel_side(const SceneObject& object, const Texture& heights) {
  double surface = 0, coordinates = 0;  // both twice the area
  for (const glm::uvec3& corner : object.mesh->triangles) {
    const Vertex &a = object.mesh->vertices[corner.x], &b = object.mesh->vertices[corner.y], &c = object.mesh->vertices[corner.z];
    const glm::dvec2 ab = b.uv - a.uv, ac = c.uv - a.uv;
    surface += glm::length(glm::cross(b.position - a.position, c.position - a.position));
    coordinates += std::abs(ab.x * ac.y - ac.x * ab.y);
  }
  const double texels = coordinates * heights.levels[0].width * heights.levels[0].height;
  return texels > 0 ? std::sqrt(surface / texels) : 0;
}

}  // namespace bump
