#pragma once
// Which triangle is seen at each pixel centre, in double precision: homogeneous edge functions (no clipped polygons, no snapped vertices),
// the top-left rule, a depth test that keeps the nearer surface and, between equals, the earlier triangle. Independent of the simulated
// rasterizer on purpose: the two must agree but for a handful of silhouette pixels. Untimed. Source: Olano and Greer, "Triangle scan
// conversion using 2D homogeneous coordinates", Graphics Hardware 1997.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "units/scene.h"

namespace bump {

/// A triangle as three affine functions over normalised device coordinates p = (x, y, 1): x to the right, y upwards, both -1 to 1 over the
/// frame. edges[i].p is the barycentric weight of corner i times one factor that all corners share, positive in front of the eye.
struct ScreenTriangle {
  std::array<glm::dvec3, 3> edges{};
  std::array<glm::dvec4, 3> clip{};
  bool drawable = false;  ///< false: edge-on, or facing away while back faces are culled

  /// True if the triangle owns the point: inside, or on a left or top edge.
  bool contains(const glm::dvec3& p) const;
  /// Perspective-correct barycentric weights at p; they sum to 1.
  glm::dvec3 weights(const glm::dvec3& p) const;
};

/// From the clip-space corners (units/projection.h). Counter-clockwise on the screen is the front.
ScreenTriangle make_screen_triangle(const std::array<glm::dvec4, 3>& clip, bool cull_back_faces);

/// What is seen through every pixel, row 0 on top.
struct Coverage {
  int width = 0, height = 0;
  std::vector<std::int32_t> object;    ///< index into Scene::objects, -1 for background
  std::vector<std::int32_t> triangle;  ///< index into the object's mesh, -1 for background
  std::vector<double> depth;           ///< in [0, 1], 1 for background
};

/// Normalised device coordinates of the centre of pixel (x, y).
glm::dvec3 pixel_centre(int x, int y, int width, int height);

/// `to_clip` holds the matrix from object to clip space of every object of the scene. `watch` (may be empty) is
/// called now and then, and may throw to end it.
Coverage cover(const Scene& scene, const std::vector<glm::dmat4>& to_clip, bool cull_back_faces, const std::function<void()>& watch = {});

}  // namespace bump
