#include "units/clipping.h"

namespace bump {

namespace {

ClipCorner between(const ClipCorner& inside, const ClipCorner& outside, double share) {
  ClipCorner corner;
  corner.position = inside.position + share * (outside.position - inside.position);
  corner.attributes.resize(inside.attributes.size());
  for (std::size_t i = 0; i < corner.attributes.size(); ++i)
    corner.attributes[i] = inside.attributes[i] + share * (outside.attributes[i] - inside.attributes[i]);
  return corner;
}

}  // namespace

ClipPlane near_plane(double near) {
  return {{0, 0, 0, 1}, -near};
}

std::vector<ClipPlane> guard_band(int width, int height, double margin) {
  // A pixel coordinate is (x / w + 1) width / 2, so "x_pixel >= -margin" reads width / 2 x + (width / 2 + margin) w >= 0.
  const double half_width = 0.5 * width, half_height = 0.5 * height;
  return {{{half_width, 0, 0, half_width + margin}, 0},
          {{-half_width, 0, 0, half_width + margin}, 0},
          {{0, half_height, 0, half_height + margin}, 0},
          {{0, -half_height, 0, half_height + margin}, 0}};
}

ClipPolygon clip(const ClipPolygon& polygon, const ClipPlane& plane) {
  ClipPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClipCorner& from = polygon[i];
    const ClipCorner& to = polygon[(i + 1) % polygon.size()];
    const double at_from = plane.distance(from.position), at_to = plane.distance(to.position);
    if (at_from >= 0) result.push_back(from);
    if (at_from >= 0 && at_to < 0) result.push_back(between(from, to, at_from / (at_from - at_to)));
    if (at_from < 0 && at_to >= 0) result.push_back(between(to, from, at_to / (at_to - at_from)));
  }
  return result;
}

}  // namespace bump
