#include "testbench/reference/coverage.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"
#include "units/projection.h"

namespace bump {

namespace {

/// Left and top edges own the points on them, so that triangles that share an edge neither overlap nor leave a gap. An edge function grows
/// towards the inside: a left edge grows to the right, a top edge (horizontal) grows downwards.
bool owns_its_points(const glm::dvec3& edge) {
  return edge.x > 0 || (edge.x == 0 && edge.y < 0);
}

struct PixelBox {
  int left = 0, top = 0, right = -1, bottom = -1;  ///< inclusive; empty if right < left
};

/// Pixels that the part of the triangle beyond the near plane can touch.
PixelBox bounds(const std::array<glm::dvec4, 3>& clip, int width, int height) {
  double left = width, right = 0, top = height, bottom = 0;
  bool anything = false;
  const auto include = [&](const glm::dvec4& corner) {
    const ScreenPosition at = to_screen(corner, width, height);
    left = std::min(left, at.x);
    right = std::max(right, at.x);
    top = std::min(top, at.y);
    bottom = std::max(bottom, at.y);
    anything = true;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 &a = clip[i], &b = clip[(i + 1) % 3];
    const double from_near_a = a.z + a.w, from_near_b = b.z + b.w;
    if (from_near_a >= 0) include(a);
    if ((from_near_a >= 0) != (from_near_b >= 0)) include(a + (b - a) * (from_near_a / (from_near_a - from_near_b)));
  }
  if (!anything) return {};
  const auto pixel = [](double position, int size) { return static_cast<int>(std::floor(std::clamp(position, -1.0, size + 1.0))); };
  // One pixel of margin for rounding; the edge functions decide.
  return {std::max(pixel(left, width) - 1, 0), std::max(pixel(top, height) - 1, 0), std::min(pixel(right, width) + 1, width - 1),
          std::min(pixel(bottom, height) + 1, height - 1)};
}

}  // namespace

bool ScreenTriangle::contains(const glm::dvec3& p) const {
  for (const glm::dvec3& edge : edges) {
    const double value = glm::dot(edge, p);
    if (!(value > 0) && !(value == 0 && owns_its_points(edge))) return false;
  }
  return true;
}

glm::dvec3 ScreenTriangle::weights(const glm::dvec3& p) const {
  const glm::dvec3 scaled{glm::dot(edges[0], p), glm::dot(edges[1], p), glm::dot(edges[2], p)};
  return scaled / (scaled.x + scaled.y + scaled.z);
}

ScreenTriangle make_screen_triangle(const std::array<glm::dvec4, 3>& clip, bool cull_back_faces) {
  ScreenTriangle triangle;
  triangle.clip = clip;
  std::array<glm::dvec3, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) corners[i] = {clip[i].x, clip[i].y, clip[i].w};
  // Rows of the adjoint of the matrix with the corners as columns. Two triangles that share an edge get exactly opposite functions.
  for (std::size_t i = 0; i < 3; ++i) triangle.edges[i] = glm::cross(corners[(i + 1) % 3], corners[(i + 2) % 3]);
  const double determinant = glm::dot(corners[0], triangle.edges[0]);
  triangle.drawable = std::isfinite(determinant) && determinant != 0 && !(cull_back_faces && determinant < 0);
  if (determinant < 0) {
    for (glm::dvec3& edge : triangle.edges) edge = -edge;
  }
  return triangle;
}

glm::dvec3 pixel_centre(int x, int y, int width, int height) {
  return {(2 * x + 1.0) / width - 1, 1 - (2 * y + 1.0) / height, 1};
}

Coverage cover(const Scene& scene, const std::vector<glm::dmat4>& to_clip, bool cull_back_faces) {
  BUMP_ASSERT(to_clip.size() == scene.objects.size());
  Coverage coverage;
  coverage.width = scene.width;
  coverage.height = scene.height;
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  coverage.object.assign(pixels, -1);
  coverage.triangle.assign(pixels, -1);
  coverage.depth.assign(pixels, 1.0);

  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Mesh& mesh = *scene.objects[o].mesh;
    std::vector<glm::dvec4> clip;
    clip.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) clip.push_back(to_clip[o] * glm::dvec4{vertex.position, 1.0});

    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const glm::uvec3& corner = mesh.triangles[t];
      const ScreenTriangle triangle = make_screen_triangle({clip[corner.x], clip[corner.y], clip[corner.z]}, cull_back_faces);
      if (!triangle.drawable) continue;
      const PixelBox box = bounds(triangle.clip, scene.width, scene.height);
      for (int y = box.top; y <= box.bottom; ++y) {
        for (int x = box.left; x <= box.right; ++x) {
          const glm::dvec3 p = pixel_centre(x, y, scene.width, scene.height);
          if (!triangle.contains(p)) continue;
          const glm::dvec3 weight = triangle.weights(p);
          const glm::dvec4 at = triangle.clip[0] * weight.x + triangle.clip[1] * weight.y + triangle.clip[2] * weight.z;
          if (at.z < -at.w || at.z > at.w) continue;
          const double depth = (at.z / at.w + 1) * 0.5;
          const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
          if (!(depth < coverage.depth[pixel])) continue;
          coverage.depth[pixel] = depth;
          coverage.object[pixel] = static_cast<std::int32_t>(o);
          coverage.triangle[pixel] = static_cast<std::int32_t>(t);
        }
      }
    }
  }
  return coverage;
}

}  // namespace bump
