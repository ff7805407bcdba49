#pragma once
// Polygon clipping in homogeneous clip space: against the near plane, and against a guard band around the frame so that screen coordinates
// fit the rasterizer's words. Attributes are affine in clip space, so new corners get them by interpolation along the edge. Part of
// triangle setup's time. Source: Sutherland and Hodgman, "Reentrant polygon clipping", CACM 17(1), 1974; in homogeneous coordinates after
// Blinn and Newell, 1978.

#include <glm/glm.hpp>
#include <vector>

namespace bump {

struct ClipCorner {
  glm::dvec4 position{0};
  std::vector<double> attributes;  ///< affine; angles already unwrapped
};

/// Convex, in order.
using ClipPolygon = std::vector<ClipCorner>;

/// Signed distances of a corner, positive inside: a plane (a, b, c, d) means a x + b y + c z + d w >= 0, `offset` is added.
struct ClipPlane {
  glm::dvec4 normal{0};
  double offset = 0;
  double distance(const glm::dvec4& position) const { return glm::dot(normal, position) + offset; }
};

/// w >= near.
ClipPlane near_plane(double near);
/// The four planes `margin` pixels outside a frame of width x height pixels.
std::vector<ClipPlane> guard_band(int width, int height, double margin);

/// The part of the polygon inside the plane; fewer than three corners when nothing is left. New corners are computed from the inside to the
/// outside end of an edge, so that two triangles that share the edge get the same point, bit for bit.
ClipPolygon clip(const ClipPolygon& polygon, const ClipPlane& plane);

}  // namespace bump
