#include "testbench/scene/mesh_frames.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace bump {

namespace {

/// Angle between two edges in radians; 0 if one has no length.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0.0;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  // Scaled first, so that tiny meshes do not underflow.
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : glm::dvec3(0);
}

glm::dvec3 orthogonal_to(const glm::dvec3& normal, const glm::dvec3& v) {
  return v - glm::dot(v, normal) * normal;
}

/// Any tangent: the axis that leans least along the normal.
glm::dvec3 any_tangent(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const glm::dvec3 axis =
      size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0) : (size.y <= size.z ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1));
  return glm::normalize(orthogonal_to(normal, axis));
}

/// Unit directions of growing s and t on a triangle; zero without texture area.
struct TextureGradients {
  glm::dvec3 along_s{0}, along_t{0};
  bool exist = false;
};

TextureGradients texture_gradients(const Vertex& v0, const Vertex& v1, const Vertex& v2) {
  const glm::dvec3 p1 = v1.position - v0.position, p2 = v2.position - v0.position;
  const glm::dvec2 t1 = v1.uv - v0.uv, t2 = v2.uv - v0.uv;
  // Plane equations A x + B s + C t + D = 0 (Cg Eq 8-7): A is the same for x, y and z; dx/ds = -B/A, dx/dt = -C/A (Eq 8-8).
  const double a = t1.x * t2.y - t1.y * t2.x;
  const double longest = std::max(glm::dot(t1, t1), glm::dot(t2, t2));
  TextureGradients gradients;
  if (!(std::abs(a) > 1e-10 * longest)) return gradients;
  const double sign = a > 0 ? 1 : -1;
  gradients.along_s = unit_or_zero(sign * (p1 * t2.y - p2 * t1.y));
  gradients.along_t = unit_or_zero(sign * (p2 * t1.x - p1 * t2.x));
  gradients.exist = gradients.along_s != glm::dvec3(0) && gradients.along_t != glm::dvec3(0);
  return gradients;
}

/// What the corners at one vertex add up to, for either handedness.
struct Blend {
  std::array<glm::dvec3, 2> tangent{glm::dvec3(0), glm::dvec3(0)};  ///< right-handed, left-handed
  std::array<bool, 2> used{false, false};
};

}  // namespace

std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles) {
  std::map<std::tuple<double, double, double>, std::size_t> first_at;
  std::vector<std::size_t> group(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    group[i] = first_at.emplace(std::make_tuple(positions[i].x, positions[i].y, positions[i].z), i).first->second;
  }
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0));
  for (const auto& triangle : triangles) {
    const glm::dvec3 corner[3] = {positions[triangle.x], positions[triangle.y], positions[triangle.z]};
    const glm::dvec3 normal = unit_or_zero(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
    for (int i = 0; i < 3; ++i) {
      const double angle = angle_between(corner[(i + 1) % 3] - corner[i], corner[(i + 2) % 3] - corner[i]);
      sums[group[triangle[i]]] += angle * normal;
    }
  }
  std::vector<glm::dvec3> normals(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3& sum = sums[group[i]];
    normals[i] = glm::length(sum) > 1e-9 ? glm::normalize(sum) : glm::dvec3(0);
  }
  return normals;
}

int box_side(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

glm::dvec2 box_coordinates(const glm::dvec3& position, int side, const glm::dvec3& low, double size) {
  const glm::dvec3 p = (position - low) / size;
  // u x v points outwards on every side; y is up, and the top joins the front (+z).
  switch (side) {
    case 0:
      return glm::dvec2(-p.z, p.y);
    case 1:
      return glm::dvec2(p.z, p.y);
    case 2:
      return glm::dvec2(p.x, -p.z);
    case 3:
      return glm::dvec2(p.x, p.z);
    case 4:
      return glm::dvec2(p.x, p.y);
    default:
      return glm::dvec2(-p.x, p.y);
  }
}

TangentReport build_tangents(Mesh& mesh) {
  TangentReport report;
  std::vector<Blend> blends(mesh.vertices.size());
  std::vector<std::array<int, 3>> side(mesh.triangles.size(), {-1, -1, -1});  // of each corner: 0 right-handed, 1 left-handed, -1 unknown
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& triangle = mesh.triangles[t];
    const Vertex* corner[3] = {&mesh.vertices[triangle.x], &mesh.vertices[triangle.y], &mesh.vertices[triangle.z]};
    const TextureGradients gradients = texture_gradients(*corner[0], *corner[1], *corner[2]);
    if (!gradients.exist) {
      ++report.without_texture_area;
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& normal = corner[i]->normal;
      const glm::dvec3 binormal_side = glm::cross(normal, gradients.along_s);
      const int hand = glm::dot(binormal_side, gradients.along_t) >= 0 ? 0 : 1;
      const double angle =
          angle_between(corner[(i + 1) % 3]->position - corner[i]->position, corner[(i + 2) % 3]->position - corner[i]->position);
      Blend& blend = blends[triangle[i]];
      blend.tangent[static_cast<std::size_t>(hand)] += angle * unit_or_zero(orthogonal_to(normal, gradients.along_s));
      blend.used[static_cast<std::size_t>(hand)] = true;
      side[t][static_cast<std::size_t>(i)] = hand;
    }
  }

  // A vertex keeps the right-handed blend if it has one; a left-handed one beside it goes to a copy.
  std::vector<unsigned> left_copy(mesh.vertices.size());
  std::vector<glm::dvec3> tangents(mesh.vertices.size());
  const std::size_t originals = mesh.vertices.size();
  for (std::size_t v = 0; v < originals; ++v) {
    const Blend& blend = blends[v];
    const bool both = blend.used[0] && blend.used[1];
    left_copy[v] = static_cast<unsigned>(both ? mesh.vertices.size() : v);
    mesh.vertices[v].handedness = blend.used[1] && !blend.used[0] ? -1 : 1;
    tangents[v] = blend.tangent[blend.used[1] && !blend.used[0] ? 1 : 0];
    if (!both) continue;
    Vertex copy = mesh.vertices[v];
    copy.handedness = -1;
    mesh.vertices.push_back(copy);
    tangents.push_back(blend.tangent[1]);
    ++report.doubled_vertices;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (side[t][static_cast<std::size_t>(i)] == 1) mesh.triangles[t][i] = left_copy[mesh.triangles[t][i]];
    }
  }

  // Vertices that no texture area reaches take their neighbours' tangents, ring by ring; what is left takes any direction.
  std::vector<bool> known(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    known[v] = glm::length(tangents[v]) > 1e-9;
    if (known[v]) mesh.vertices[v].tangent = glm::normalize(orthogonal_to(mesh.vertices[v].normal, glm::normalize(tangents[v])));
  }
  constexpr int most_rings = 64;
  bool progress = report.without_texture_area > 0;
  for (int ring = 0; progress && ring < most_rings; ++ring) {
    progress = false;
    std::map<unsigned, glm::dvec3> found;
    for (const auto& triangle : mesh.triangles) {
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3 && !known[triangle[i]]; ++j) {
          if (!known[triangle[j]]) continue;
          found.emplace(triangle[i], glm::dvec3(0)).first->second +=
              orthogonal_to(mesh.vertices[triangle[i]].normal, mesh.vertices[triangle[j]].tangent);
        }
      }
    }
    for (const auto& [v, sum] : found) {
      if (glm::length(sum) < 1e-3) continue;
      mesh.vertices[v].tangent = glm::normalize(orthogonal_to(mesh.vertices[v].normal, glm::normalize(sum)));
      known[v] = true;
      progress = true;
    }
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!known[v]) mesh.vertices[v].tangent = any_tangent(mesh.vertices[v].normal);
  }
  return report;
}

}  // namespace bump
