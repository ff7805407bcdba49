#include <cmath>
#include <random>

#include "scene_bench.h"
#include "testbench/scene/mesh_frames.h"
#include "testbench/scene/shapes.h"

using namespace bump;
using namespace bump::test;

namespace {

constexpr double pi = 3.14159265358979323846;

double surface_area(const Mesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 a = mesh.vertices[t.x].position;
    area += 0.5 * glm::length(glm::cross(mesh.vertices[t.y].position - a, mesh.vertices[t.z].position - a));
  }
  return area;
}

/// Signed volume enclosed: positive when all triangles are counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += glm::dot(mesh.vertices[t.x].position, glm::cross(mesh.vertices[t.y].position, mesh.vertices[t.z].position)) / 6;
  }
  return sum;
}

double worst_tangent_error(const Mesh& mesh, bool skip_poles) {
  Mesh derived = mesh;
  build_tangents(derived);
  double worst = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (skip_poles && std::abs(mesh.vertices[i].normal.z) == 1) continue;
    worst = std::max(worst, glm::distance(mesh.vertices[i].tangent, derived.vertices[i].tangent));
    CHECK(derived.vertices[i].handedness == mesh.vertices[i].handedness);
  }
  return worst;
}

glm::dvec3 into_frame(const Vertex& vertex, const glm::dvec3& v) {
  return glm::dvec3(glm::dot(v, vertex.tangent), vertex.handedness * glm::dot(v, glm::cross(vertex.normal, vertex.tangent)),
                    glm::dot(v, vertex.normal));
}

/// Diffuse term of a bumped normal with light interpolated as tangent-space vectors, against interpolated and orthonormalised frames. PSNR
/// in dB.
double interpolation_psnr(const Mesh& mesh) {
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  double squared = 0, count = 0;
  for (const auto& t : mesh.triangles) {
    const Vertex* corner[3] = {&mesh.vertices[t.x], &mesh.vertices[t.y], &mesh.vertices[t.z]};
    for (int trial = 0; trial < 3; ++trial) {
      const double a = std::sqrt(uniform()), b = uniform();
      const double weight[3] = {1 - a, a * (1 - b), a * b};
      const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
      const glm::dvec3 bump = glm::normalize(glm::dvec3(0.6 * uniform() - 0.3, 0.6 * uniform() - 0.3, 1));
      glm::dvec3 in_frame(0), normal(0), tangent(0);
      for (int i = 0; i < 3; ++i) {
        in_frame += weight[i] * into_frame(*corner[i], light);
        normal += weight[i] * corner[i]->normal;
        tangent += weight[i] * corner[i]->tangent;
      }
      Vertex exact;
      exact.normal = glm::normalize(normal);
      exact.tangent = glm::normalize(tangent - glm::dot(tangent, exact.normal) * exact.normal);
      exact.handedness = corner[0]->handedness;
      const double interpolated = std::max(0.0, glm::dot(bump, glm::normalize(in_frame)));
      const double reference = std::max(0.0, glm::dot(bump, into_frame(exact, light)));
      squared += (interpolated - reference) * (interpolated - reference);
      ++count;
    }
  }
  return squared == 0 ? 200 : -10 * std::log10(squared / count);
}

}  // namespace

TEST_CASE("every shape has orthonormal frames and faces outwards") {
  for (const Mesh& mesh : {make_plane(2, 3, 5, 7), make_cube(2, 4), make_sphere(1, 16, 8), make_sphere(2, 3, 2), make_torus(1, 0.4, 16, 8),
                           make_torus(1, 0.4, 3, 3)}) {
    check_mesh(mesh);
  }
}

TEST_CASE("shapes have their area and volume") {
  CHECK(surface_area(make_plane(2, 3, 5, 7)) == Approx(6));
  CHECK(surface_area(make_cube(2, 4)) == Approx(24));
  CHECK(volume(make_cube(2, 4)) == Approx(8));
  CHECK(volume(make_sphere(1, 128, 64)) == Approx(4 * pi / 3).epsilon(0.005));
  CHECK(volume(make_torus(1, 0.4, 128, 64)) == Approx(2 * pi * pi * 0.16).epsilon(0.005));
}

TEST_CASE("the sphere's frame is east, north, up at every vertex") {
  for (const Vertex& vertex : make_sphere(1.5, 24, 12).vertices) {
    const double longitude = 2 * pi * vertex.uv.x, latitude = pi * (vertex.uv.y - 0.5);
    const glm::dvec3 up(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude));
    const glm::dvec3 east(-std::sin(longitude), std::cos(longitude), 0);
    const glm::dvec3 north(-std::sin(latitude) * std::cos(longitude), -std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    CHECK(glm::distance(vertex.position, 1.5 * up) < 1e-12);
    CHECK(glm::distance(vertex.normal, up) < 1e-12);
    CHECK(glm::distance(vertex.tangent, east) < 1e-12);
    CHECK(glm::distance(vertex.handedness * glm::cross(vertex.normal, vertex.tangent), north) < 1e-12);
  }
}

TEST_CASE("the torus's frame is the normalised derivatives of its equations") {
  const double m = 1.2, n = 0.5;
  for (const Vertex& vertex : make_torus(m, n, 24, 12).vertices) {
    const double s = 2 * pi * vertex.uv.x, t = 2 * pi * vertex.uv.y;
    CHECK(glm::distance(vertex.position,
                        glm::dvec3((m + n * std::cos(t)) * std::cos(s), (m + n * std::cos(t)) * std::sin(s), n * std::sin(t))) < 1e-12);
    CHECK(glm::distance(vertex.tangent, glm::dvec3(-std::sin(s), std::cos(s), 0)) < 1e-12);
    const glm::dvec3 along_t(-std::sin(t) * std::cos(s), -std::sin(t) * std::sin(s), std::cos(t));
    CHECK(glm::distance(vertex.handedness * glm::cross(vertex.normal, vertex.tangent), along_t) < 1e-12);
  }
}

TEST_CASE("seams close: texture edges lie at bit-equal positions") {
  const Mesh sphere = make_sphere(1, 20, 10), torus = make_torus(1, 0.4, 20, 10);
  for (const Mesh* mesh : {&sphere, &torus}) {
    for (const Vertex& left : mesh->vertices) {
      if (left.uv.x != 0) continue;
      bool met = false;
      for (const Vertex& right : mesh->vertices)
        met = met || (right.uv.x == 1 && right.uv.y == left.uv.y && right.position == left.position);
      CHECK(met);
    }
  }
}

TEST_CASE("frames derived from the texture agree with the analytic ones") {
  CHECK(worst_tangent_error(make_plane(2, 3, 4, 4), false) < 1e-12);
  CHECK(worst_tangent_error(make_cube(2, 3), false) < 1e-12);
  CHECK(worst_tangent_error(make_sphere(1, 96, 48), true) < 0.05);
  CHECK(worst_tangent_error(make_torus(1, 0.4, 96, 48), false) < 0.05);
}

TEST_CASE("frames follow a texture that is scaled or mirrored") {
  for (const double u : {2.0, -6.0}) {
    for (const double v : {3.0, -2.0}) {
      Mesh plane = make_plane(2, 2, 2, 2);
      scale_texture(plane, u, v);
      check_mesh(plane);
      CHECK(worst_tangent_error(plane, false) < 1e-12);
      CHECK(plane.vertices[0].tangent.x == (u > 0 ? 1 : -1));
      CHECK(plane.vertices[0].handedness == (u * v > 0 ? 1 : -1));
    }
  }
}

TEST_CASE("default tessellations keep interpolated vectors within 50 dB of interpolated frames") {
  CHECK(interpolation_psnr(make_plane(2, 2, 16, 16)) > 50);
  CHECK(interpolation_psnr(make_cube(2, 8)) > 50);
  CHECK(interpolation_psnr(make_sphere(1, 64, 32)) > 50);
  CHECK(interpolation_psnr(make_torus(1, 0.4, 64, 32)) > 50);
}
