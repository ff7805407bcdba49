#include <cmath>
#include <random>

#include "scene_bench.h"
#include "testbench/scene/mesh_frames.h"

using namespace bump;
using namespace bump::test;

namespace {

/// A grid bent at random, with texture coordinates from `texture`.
Mesh random_sheet(unsigned seed, int side, const std::function<glm::dvec2(int, int)>& texture) {
  std::mt19937 random(seed);
  const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  std::vector<glm::dvec3> positions;
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      positions.emplace_back(x + 0.4 * noise(), y + 0.4 * noise(), noise());
      Vertex vertex;
      vertex.position = positions.back();
      vertex.uv = texture(x, y);
      mesh.vertices.push_back(vertex);
    }
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const unsigned a = static_cast<unsigned>(y * (side + 1) + x), up = static_cast<unsigned>(side) + 1;
      mesh.triangles.emplace_back(a, a + 1, a + up + 1);
      mesh.triangles.emplace_back(a, a + up + 1, a + up);
    }
  }
  const auto normals = smooth_normals(positions, mesh.triangles);
  for (std::size_t i = 0; i < normals.size(); ++i) mesh.vertices[i].normal = normals[i];
  return mesh;
}

}  // namespace

TEST_CASE("frames of random meshes are orthonormal, and their tangents grow with u") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh = random_sheet(seed, 8, [&](int x, int y) {
      return glm::dvec2(x + 0.3 * static_cast<double>(random()) / 4294967296.0, y + 0.3 * static_cast<double>(random()) / 4294967296.0);
    });
    const TangentReport report = build_tangents(mesh);
    check_mesh(mesh);
    CHECK(report.doubled_vertices == 0);
    for (const auto& vertex : mesh.vertices) {
      CHECK(vertex.handedness == 1);
      CHECK(vertex.tangent.x > 0);
    }
  }
}

TEST_CASE("completely random texture coordinates still give orthonormal frames") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Mesh mesh =
        random_sheet(seed, 6, [&](int, int) { return glm::dvec2(static_cast<double>(random() % 4), static_cast<double>(random() % 4)); });
    build_tangents(mesh);
    check_mesh(mesh);
  }
}

TEST_CASE("a mirrored texture doubles the vertices on its axis and flips their handedness") {
  const int side = 8;
  Mesh mesh = random_sheet(5, side, [&](int x, int y) { return glm::dvec2(std::abs(x - side / 2), y); });
  const TangentReport report = build_tangents(mesh);
  check_mesh(mesh);
  CHECK(report.doubled_vertices == side + 1);
  for (const auto& triangle : mesh.triangles) {
    double x = 0;
    for (int i = 0; i < 3; ++i) x += mesh.vertices[triangle[i]].position.x / 3;
    const double hand = mesh.vertices[triangle.x].handedness;
    if (std::abs(x - side / 2) > 1) CHECK(hand == (x < side / 2.0 ? -1 : 1));
    for (int i = 0; i < 3; ++i) {
      CHECK(mesh.vertices[triangle[i]].handedness == hand);
      // The tangent runs along growing u: away from the axis.
      CHECK(mesh.vertices[triangle[i]].tangent.x * hand > 0);
    }
  }
}

TEST_CASE("triangles without texture area take their neighbours' tangents") {
  Mesh mesh = random_sheet(9, 8, [](int x, int y) { return x < 4 ? glm::dvec2(y, -x) : glm::dvec2(7, -4); });
  const TangentReport report = build_tangents(mesh);
  check_mesh(mesh);
  CHECK(report.without_texture_area >= 2 * 4 * 8);
  for (const auto& vertex : mesh.vertices) CHECK(vertex.tangent.y > 0);
}

TEST_CASE("a mesh without any texture area gets some tangents") {
  Mesh mesh = random_sheet(4, 3, [](int, int) { return glm::dvec2(0); });
  CHECK(build_tangents(mesh).without_texture_area == 18);
  check_mesh(mesh);
}

TEST_CASE("smooth normals do not depend on how flat faces are cut") {
  // A cube's corner: three squares, each cut along either diagonal.
  const std::vector<glm::dvec3> p = {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0), glm::dvec3(0, 1, 0),
                                     glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 1), glm::dvec3(0, 1, 1)};
  const unsigned squares[3][4] = {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 6, 3}};
  for (int cut = 0; cut < 8; ++cut) {
    std::vector<glm::uvec3> triangles;
    for (int i = 0; i < 3; ++i) {
      const auto& s = squares[i];
      if ((cut >> i & 1) == 0) {
        triangles.emplace_back(s[0], s[1], s[2]);
        triangles.emplace_back(s[0], s[2], s[3]);
      } else {
        triangles.emplace_back(s[0], s[1], s[3]);
        triangles.emplace_back(s[1], s[2], s[3]);
      }
    }
    CHECK(glm::distance(smooth_normals(p, triangles)[0], glm::normalize(glm::dvec3(-1))) < 1e-12);
  }
}

TEST_CASE("box projection is right-handed seen from every side") {
  for (int side = 0; side < 6; ++side) {
    const glm::dvec2 origin = box_coordinates(glm::dvec3(0), side, glm::dvec3(0), 2);
    glm::dvec3 along_u(0), along_v(0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = 2;
      const glm::dvec2 change = box_coordinates(step, side, glm::dvec3(0), 2) - origin;
      along_u[axis] = change.x;
      along_v[axis] = change.y;
    }
    CHECK(box_side(glm::cross(along_u, along_v)) == side);
    CHECK(glm::length(glm::cross(along_u, along_v)) == 1);
  }
}
