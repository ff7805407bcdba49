#include "testbench/reference/coverage.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
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

/// An edge function along a row of pixels: the same sums, in the same order, as glm::dot(edge, pixel centre).
struct RowEdge {
  double across, row, constant;
  bool owns_zero;
  RowEdge(const glm::dvec3& edge, double y) : across(edge.x), row(edge.y * y), constant(edge.z), owns_zero(owns_its_points(edge)) {}
  bool contains(double x) const {
    const double value = across * x + row + constant;
    return value > 0 || (value == 0 && owns_zero);
  }
};

/// Pixels [first, end) of a row.
struct Run {
  int first, end;
};

/// Those among [first, end) that the triangle owns. Rounding keeps an edge function monotonic along a row, so each edge cuts a row once.
Run owned_run(const RowEdge edges[3], const std::vector<double>& x, Run run) {
  for (int i = 0; i < 3; ++i) {
    const RowEdge& edge = edges[i];
    const double *begin = x.data() + run.first, *end = x.data() + run.end;
    if (edge.across > 0) {
      run.first += static_cast<int>(std::partition_point(begin, end, [&](double at) { return !edge.contains(at); }) - begin);
    } else if (edge.across < 0) {
      run.end -= static_cast<int>(end - std::partition_point(begin, end, [&](double at) { return edge.contains(at); }));
    } else if (begin != end && !edge.contains(*begin)) {
      run.end = run.first;
    }
  }
  return run;
}

/// Rows of z and w: what depth needs of the clip-space corners.
struct ClipDepth {
  double z[3], w[3];
};

constexpr double beyond = 2;  ///< deeper than anything stored

/// Depth in [0, 1] at `count` pixels, `beyond` outside the near and far planes.
BUMP_LANE_LOOP void depths_of_run(const RowEdge* edges, const ClipDepth& clip, const double* __restrict x, int count,
                                  double* __restrict depth) {
  const RowEdge a = edges[0], b = edges[1], c = edges[2];
  const ClipDepth corner = clip;
  for (int i = 0; i < count; ++i) {
    const double wa = a.across * x[i] + a.row + a.constant, wb = b.across * x[i] + b.row + b.constant,
                 wc = c.across * x[i] + c.row + c.constant;
    const double sum = wa + wb + wc, sa = wa / sum, sb = wb / sum, sc = wc / sum;
    const double z = corner.z[0] * sa + corner.z[1] * sb + corner.z[2] * sc, w = corner.w[0] * sa + corner.w[1] * sb + corner.w[2] * sc;
    const double inside = (z / w + 1) * 0.5;
    const bool is_outside = (z < -w) | (z > w);
    depth[i] = is_outside ? beyond : inside;
  }
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

Coverage cover(const Scene& scene, const std::vector<glm::dmat4>& to_clip, bool cull_back_faces, const std::function<void()>& watch) {
  BUMP_ASSERT(to_clip.size() == scene.objects.size());
  Coverage coverage;
  coverage.width = scene.width;
  coverage.height = scene.height;
  const std::size_t pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  coverage.object.assign(pixels, -1);
  coverage.triangle.assign(pixels, -1);
  coverage.depth.assign(pixels, 1.0);
  std::vector<double> x_of_column, depth(static_cast<std::size_t>(scene.width));
  for (int x = 0; x < scene.width; ++x) x_of_column.push_back(pixel_centre(x, 0, scene.width, scene.height).x);

  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Mesh& mesh = *scene.objects[o].mesh;
    std::vector<glm::dvec4> clip;
    clip.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) clip.push_back(to_clip[o] * glm::dvec4{vertex.position, 1.0});

    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (watch) watch();
      const glm::uvec3& corner = mesh.triangles[t];
      const ScreenTriangle triangle = make_screen_triangle({clip[corner.x], clip[corner.y], clip[corner.z]}, cull_back_faces);
      if (!triangle.drawable) continue;
      const PixelBox box = bounds(triangle.clip, scene.width, scene.height);
      const auto& corners = triangle.clip;
      const ClipDepth clip_depth{{corners[0].z, corners[1].z, corners[2].z}, {corners[0].w, corners[1].w, corners[2].w}};
      for (int y = box.top; y <= box.bottom; ++y) {
        const double at = pixel_centre(0, y, scene.width, scene.height).y;
        const RowEdge edges[3] = {{triangle.edges[0], at}, {triangle.edges[1], at}, {triangle.edges[2], at}};
        const Run run = owned_run(edges, x_of_column, {box.left, std::max(box.right + 1, box.left)});
        if (run.end <= run.first) continue;
        depths_of_run(edges, clip_depth, &x_of_column[static_cast<std::size_t>(run.first)], run.end - run.first, depth.data());
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width);
        for (int x = run.first; x < run.end; ++x) {
          const std::size_t pixel = row + static_cast<std::size_t>(x);
          const double here = depth[static_cast<std::size_t>(x - run.first)];
          if (!(here < coverage.depth[pixel])) continue;
          coverage.depth[pixel] = here;
          coverage.object[pixel] = static_cast<std::int32_t>(o);
          coverage.triangle[pixel] = static_cast<std::int32_t>(t);
        }
      }
    }
  }
  return coverage;
}

}  // namespace bump
