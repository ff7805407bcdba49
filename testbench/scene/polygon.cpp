#include "testbench/scene/polygon.h"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace bump {

namespace {

double signed_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The outline seen along its normal (Newell), counter-clockwise; scaled by nothing.
std::vector<glm::dvec2> flatten(const std::vector<glm::dvec3>& outline) {
  glm::dvec3 normal(0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    normal += glm::cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  }
  const glm::dvec3 size = glm::abs(normal);
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int first = (drop + 1) % 3, second = (drop + 2) % 3;
  std::vector<glm::dvec2> flat;
  for (const auto& corner : outline) {
    flat.emplace_back(normal[drop] >= 0 ? corner[first] : corner[second], normal[drop] >= 0 ? corner[second] : corner[first]);
  }
  return flat;
}

bool is_ear(const std::vector<glm::dvec2>& flat, const std::vector<int>& left, std::size_t at) {
  const std::size_t n = left.size();
  const auto corner = [&](std::size_t i) { return flat[static_cast<std::size_t>(left[i % n])]; };
  const glm::dvec2 a = corner(at + n - 1), b = corner(at), c = corner(at + 1);
  if (!(signed_area(a, b, c) > 0)) return false;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const glm::dvec2 p = corner(at + i);
    if (signed_area(a, b, p) > 0 && signed_area(b, c, p) > 0 && signed_area(c, a, p) >= 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<glm::dvec3>& outline) {
  std::vector<std::array<int, 3>> triangles;
  if (outline.size() == 3) return {{0, 1, 2}};
  const std::vector<glm::dvec2> flat = flatten(outline);
  std::vector<int> left(outline.size());
  std::iota(left.begin(), left.end(), 0);
  std::size_t at = 1;  // the first ear tried is the one that makes a fan of a convex polygon
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t ear = at % n;
    for (std::size_t tried = 0; tried < n && !is_ear(flat, left, ear); ++tried) ear = (ear + 1) % n;
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace bump
