#pragma once
// Small scenes for the tests of the reference renderer: analytic shapes whose right picture is known in closed form.

#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <memory>

#include "units/scene.h"

namespace bump::shapes {

constexpr double pi = 3.14159265358979323846;

/// A square plane of side `size` in z = 0, facing +z, in cells x cells squares; u along x, v along y. With `mirrored`, u runs against x.
inline std::shared_ptr<Mesh> plane(int cells, double size, bool mirrored = false) {
  auto mesh = std::make_shared<Mesh>();
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      Vertex vertex;
      const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
      vertex.position = {(s - 0.5) * size, (t - 0.5) * size, 0};
      vertex.uv = {mirrored ? 1 - s : s, t};
      vertex.tangent = {mirrored ? -1 : 1, 0, 0};
      vertex.handedness = mirrored ? -1 : 1;
      mesh->vertices.push_back(vertex);
    }
  }
  const auto row = static_cast<unsigned>(cells + 1);
  for (unsigned j = 0; j < static_cast<unsigned>(cells); ++j) {
    for (unsigned i = 0; i < static_cast<unsigned>(cells); ++i) {
      const unsigned a = j * row + i;
      mesh->triangles.emplace_back(a, a + 1, a + row + 1);
      mesh->triangles.emplace_back(a, a + row + 1, a + row);
    }
  }
  return mesh;
}

/// A unit sphere about the y axis with exact normals; u round the equator, v from the south to the north pole.
inline std::shared_ptr<Mesh> sphere(int rings) {
  auto mesh = std::make_shared<Mesh>();
  const int around = 2 * rings;
  for (int j = 0; j <= rings; ++j) {
    for (int i = 0; i <= around; ++i) {
      const double longitude = 2 * pi * i / around, latitude = pi * (static_cast<double>(j) / rings - 0.5);
      Vertex vertex;
      vertex.position = {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
      vertex.normal = vertex.position;
      vertex.tangent = {std::cos(longitude), 0, -std::sin(longitude)};
      vertex.uv = {static_cast<double>(i) / around, static_cast<double>(j) / rings};
      mesh->vertices.push_back(vertex);
    }
  }
  const auto row = static_cast<unsigned>(around + 1);
  for (unsigned j = 0; j < static_cast<unsigned>(rings); ++j) {
    for (unsigned i = 0; i < static_cast<unsigned>(around); ++i) {
      const unsigned a = j * row + i;
      mesh->triangles.emplace_back(a, a + 1, a + row + 1);
      mesh->triangles.emplace_back(a, a + row + 1, a + row);
    }
  }
  return mesh;
}

inline std::shared_ptr<Texture> texture(int width, int height, int channels, const std::function<void(int, int, double*)>& fill) {
  auto result = std::make_shared<Texture>();
  result->channels = channels;
  result->kinds.assign(static_cast<std::size_t>(channels), ChannelKind::linear);
  TextureLevel level;
  level.width = width;
  level.height = height;
  level.texels.resize(static_cast<std::size_t>(width * height * channels));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) fill(x, y, &level.texels[static_cast<std::size_t>((y * width + x) * channels)]);
  result->levels.push_back(level);
  return result;
}

inline std::shared_ptr<Texture> flat_normals() {
  return texture(4, 4, 3, [](int, int, double* texel) { texel[0] = texel[1] = 0, texel[2] = 1; });
}

/// Periodic hills, in texels.
inline std::shared_ptr<Texture> hills(int size, double amplitude) {
  return texture(size, size, 1, [=](int x, int y, double* texel) {
    texel[0] = amplitude * (std::sin(2 * pi * 3 * (x + 0.5) / size) + std::cos(2 * pi * 2 * (y + 0.5) / size));
  });
}

/// The square-patch normals of a height map in texels: central differences, repeated at the edges.
inline std::shared_ptr<Texture> normals_of(const Texture& heights) {
  const TextureLevel& level = heights.levels[0];
  const auto at = [&](int x, int y) {
    return level.texels[static_cast<std::size_t>((y + level.height) % level.height * level.width + (x + level.width) % level.width)];
  };
  return texture(level.width, level.height, 3, [&](int x, int y, double* texel) {
    const glm::dvec3 n = glm::normalize(glm::dvec3{(at(x - 1, y) - at(x + 1, y)) / 2, (at(x, y - 1) - at(x, y + 1)) / 2, 1});
    texel[0] = n.x, texel[1] = n.y, texel[2] = n.z;
  });
}

/// One object before a camera on the z axis, one light.
inline Scene scene(std::shared_ptr<const Mesh> mesh, int size = 64) {
  Scene result;
  result.name = "test";
  result.width = result.height = size;
  result.camera.eye = {0, 0, 4};
  Light light;
  light.vector = glm::normalize(glm::dvec3{0.3, 0.4, 1});
  result.lights.push_back(light);
  SceneObject object;
  object.name = "shape";
  object.mesh = std::move(mesh);
  object.normals = flat_normals();
  result.objects.push_back(object);
  return result;
}

}  // namespace bump::shapes
