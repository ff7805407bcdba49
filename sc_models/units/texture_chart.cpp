#include "units/texture_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

/// Twice the area of a, b, q: exactly the opposite number for b, a, q, so that a point on a common edge is on the edge for both triangles.
double side_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& q) {
  const bool ordered = a.x < b.x || (a.x == b.x && a.y < b.y);
  const glm::dvec2 &from = ordered ? a : b, &to = ordered ? b : a;
  const double area = (to.x - from.x) * (q.y - from.y) - (q.x - from.x) * (to.y - from.y);
  return ordered ? area : -area;
}

/// Whether q lies in the counter-clockwise triangle; of the points on its edges only those on left and top ones.
bool inside(const std::array<glm::dvec2, 3>& corner, const glm::dvec2& q) {
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 &a = corner[i], &b = corner[(i + 1) % 3];
    const double side = side_of(a, b, q);
    const bool owned = b.y < a.y || (b.y == a.y && b.x < a.x);
    if (side < 0 || (side == 0 && !owned)) return false;
  }
  return true;
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

glm::dmat3 frame_of(const glm::dvec3& normal, const glm::dvec3& tangent, double handedness) {
  const glm::dvec3 n = unit_or(normal, {0, 0, 1});
  const glm::dvec3 axis = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 t = unit_or(tangent - n * glm::dot(n, tangent), glm::normalize(axis - n * glm::dot(n, axis)));
  return {t, (handedness < 0 ? -1.0 : 1.0) * glm::cross(n, t), n};
}

double angle_between_frames(const SurfaceTexel& a, const SurfaceTexel& b) {
  const auto angle = [](const glm::dvec3& p, const glm::dvec3& q) { return 2 * std::asin(std::min(1.0, glm::length(p - q) / 2)); };
  return std::max(angle(a.frame[0], b.frame[0]), angle(a.frame[2], b.frame[2]));
}

std::string count_of(double whole) {
  return whole < 1e15 ? std::to_string(static_cast<long long>(whole)) : "countless";
}

std::string text_of(const glm::dvec3& p) {
  const auto rounded = [](double value) {
    std::string text = std::to_string(value);  // six decimals
    text.erase(text.size() - 3);
    return text;
  };
  return "(" + rounded(p.x) + ", " + rounded(p.y) + ", " + rounded(p.z) + ")";
}

}  // namespace

TextureChart::TextureChart(const SceneObject& object, const Texture& texture, const Agree& agree, const std::string& remedy)
    : object_(object) {
  BUMP_ASSERT(object.mesh && !texture.levels.empty());
  place(texture, remedy);
  const std::size_t texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  triangle_.assign(texels, -1);
  for (std::size_t i = 0; i < object.mesh->triangles.size(); ++i) cover(static_cast<std::int32_t>(i), agree, remedy);
  if (std::all_of(triangle_.begin(), triangle_.end(), [](std::int32_t triangle) { return triangle < 0; }))
    throw Error({"no texel of the bump map lies on object '" + object.name + "'", {}, "its texture coordinates span no area", remedy});
  wrap_u_ = border_mode(texture.wrap_u, true);
  wrap_v_ = border_mode(texture.wrap_v, false);
  borrow();
}

void TextureChart::place(const Texture& texture, const std::string& remedy) {
  // Coordinates that rounding has pushed over a border do not ask for another repeat.
  constexpr double tolerance = 1e-6;
  glm::dvec2 low{0}, high{0};
  for (std::size_t i = 0; i < object_.mesh->vertices.size(); ++i) {
    const glm::dvec2& uv = object_.mesh->vertices[i].uv;
    low = i == 0 ? uv : glm::min(low, uv);
    high = i == 0 ? uv : glm::max(high, uv);
  }
  origin_ = glm::floor(low + tolerance);
  repeats_ = glm::max(glm::ceil(high - tolerance) - origin_, glm::dvec2(1));
  glm::dvec2 size = repeats_ * glm::dvec2(texture.levels[0].width, texture.levels[0].height);
  for (int axis = 0; axis < 2; ++axis)
    while (size[axis] < least_side) size[axis] *= 2;
  if (!(size.x * size.y <= static_cast<double>(largest_area)))
    throw Error({"a bump map for the whole surface of object '" + object_.name + "' is too large",
                 {},
                 "its texture repeats " + count_of(repeats_.x) + " x " + count_of(repeats_.y) + " times, " + count_of(size.x) + " x " +
                     count_of(size.y) + " texels in all; at most 4096 x 4096 are made",
                 "a smaller uv_scale, or " + remedy});
  width_ = static_cast<int>(size.x);
  height_ = static_cast<int>(size.y);
}

glm::dvec2 TextureChart::centre(int x, int y) const {
  return origin_ + glm::dvec2((x + 0.5) / width_, (y + 0.5) / height_) * repeats_;
}

void TextureChart::cover(std::int32_t triangle, const Agree& agree, const std::string& remedy) {
  const glm::uvec3& corners = object_.mesh->triangles[static_cast<std::size_t>(triangle)];
  const glm::dvec2 scale = glm::dvec2(width_, height_) / repeats_;
  std::array<glm::dvec2, 3> corner;
  for (int i = 0; i < 3; ++i) corner[static_cast<std::size_t>(i)] = (object_.mesh->vertices[corners[i]].uv - origin_) * scale;
  const double area = side_of(corner[0], corner[1], corner[2]);
  if (area == 0) return;
  if (area < 0) std::swap(corner[1], corner[2]);
  const glm::dvec2 low = glm::min(glm::min(corner[0], corner[1]), corner[2]), high = glm::max(glm::max(corner[0], corner[1]), corner[2]);
  const auto first = [](double edge) { return std::max(0, static_cast<int>(std::floor(edge - 0.5))); };
  const auto last = [](double edge, int size) { return std::min(size - 1, static_cast<int>(std::ceil(edge - 0.5))); };
  for (int y = first(low.y); y <= last(high.y, height_); ++y)
    for (int x = first(low.x); x <= last(high.x, width_); ++x)
      if (inside(corner, {x + 0.5, y + 0.5})) cover_texel(x, y, triangle, agree, remedy);
}

void TextureChart::cover_texel(int x, int y, std::int32_t triangle, const Agree& agree, const std::string& remedy) {
  std::int32_t& owner = triangle_[index(x, y)];
  if (owner < 0) {
    owner = triangle;
    return;
  }
  const SurfaceTexel one = surface(owner, centre(x, y)), other = surface(triangle, centre(x, y));
  // Neighbours on the surface, whose coordinates overlap by rounding, share the texel as they share an edge.
  const double texel = glm::length(one.along_u) * repeats_.x / width_ + glm::length(one.along_v) * repeats_.y / height_;
  if (glm::length(one.position - other.position) <= 2 * texel || agree(one, other)) return;
  throw Error({"the bump map of object '" + object_.name + "' cannot belong to its surface",
               {},
               "texel (" + std::to_string(x) + ", " + std::to_string(y) + ") lies on two places of it that need different normals, at " +
                   text_of(one.position) + " and " + text_of(other.position),
               "texture coordinates that use each texel once, or " + remedy});
}

SurfaceTexel TextureChart::surface(std::int32_t triangle, const glm::dvec2& uv) const {
  const glm::uvec3& corners = object_.mesh->triangles[static_cast<std::size_t>(triangle)];
  const Vertex &a = object_.mesh->vertices[corners.x], &b = object_.mesh->vertices[corners.y], &c = object_.mesh->vertices[corners.z];
  const glm::dvec2 ab = b.uv - a.uv, ac = c.uv - a.uv, aq = uv - a.uv;
  const double area = ab.x * ac.y - ac.x * ab.y;
  const double beta = (aq.x * ac.y - ac.x * aq.y) / area, gamma = (ab.x * aq.y - aq.x * ab.y) / area, alpha = 1 - beta - gamma;
  const glm::dvec3 edge_b = b.position - a.position, edge_c = c.position - a.position;
  SurfaceTexel texel;
  texel.uv = uv;
  texel.position = alpha * a.position + beta * b.position + gamma * c.position;
  texel.frame = frame_of(alpha * a.normal + beta * b.normal + gamma * c.normal, alpha * a.tangent + beta * b.tangent + gamma * c.tangent,
                         alpha * a.handedness + beta * b.handedness + gamma * c.handedness);
  texel.along_u = (edge_b * ac.y - edge_c * ab.y) / area;
  texel.along_v = (edge_c * ab.x - edge_b * ac.x) / area;
  return texel;
}

WrapMode TextureChart::border_mode(WrapMode wrap, bool across) const {
  if (wrap == WrapMode::clamp) return wrap;
  const int size = across ? width_ : height_, rows = across ? height_ : width_;
  const auto on_row = [&](int i, int row, SurfaceTexel& texel) {
    const int x = across ? i : row, y = across ? row : i;
    const std::int32_t triangle = triangle_[index(x, y)];
    if (triangle >= 0) texel = surface(triangle, centre(x, y));
    return triangle >= 0;
  };
  for (int row = 0; row < rows; ++row) {
    SurfaceTexel first, second, before_last, last;
    if (!on_row(0, row, first) || !on_row(1, row, second) || !on_row(size - 2, row, before_last) || !on_row(size - 1, row, last)) continue;
    // A surface that closes turns no more over the border than over texels beside it; the constant forgives rounding.
    const double beside = angle_between_frames(first, second) + angle_between_frames(before_last, last);
    if (angle_between_frames(first, last) > 2 * beside + 1e-3) return WrapMode::clamp;
  }
  return wrap;
}

void TextureChart::borrow() {
  lender_.assign(triangle_.size(), -1);
  std::vector<std::int32_t> front;
  for (std::size_t i = 0; i < triangle_.size(); ++i)
    if (triangle_[i] >= 0) {
      lender_[i] = static_cast<std::int32_t>(i);
      front.push_back(static_cast<std::int32_t>(i));
    }
  const auto neighbour = [](int i, int size, WrapMode wrap) {
    return wrap == WrapMode::repeat ? (i + size) % size : std::clamp(i, 0, size - 1);
  };
  // Breadth first: nearest counts steps along rows and columns.
  for (std::size_t head = 0; head < front.size(); ++head) {
    const int x = front[head] % width_, y = front[head] / width_;
    const std::int32_t lender = lender_[static_cast<std::size_t>(front[head])];
    const auto lend = [&](int to_x, int to_y) {
      std::int32_t& other = lender_[index(to_x, to_y)];
      if (other >= 0) return;
      other = lender;
      front.push_back(static_cast<std::int32_t>(index(to_x, to_y)));
    };
    lend(neighbour(x - 1, width_, wrap_u_), y);
    lend(neighbour(x + 1, width_, wrap_u_), y);
    lend(x, neighbour(y - 1, height_, wrap_v_));
    lend(x, neighbour(y + 1, height_, wrap_v_));
  }
}

SurfaceTexel TextureChart::at(int x, int y) const {
  const std::int32_t lender = lender_[index(x, y)];
  SurfaceTexel texel = surface(triangle_[static_cast<std::size_t>(lender)], centre(lender % width_, lender / width_));
  texel.uv = centre(x, y);
  return texel;
}

}  // namespace bump
