#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "datapath/error.h"
#include "testbench/tests/units/samples.h"
#include "units/surface_map.h"

namespace bump {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Texture coordinates from `low` to `high`, cells x cells quadrilaterals, lifted by `lift`.
std::shared_ptr<Mesh> sheet(int cells, const glm::dvec2& low, const glm::dvec2& high,
                            const std::function<Vertex(const glm::dvec2&)>& lift) {
  auto mesh = std::make_shared<Mesh>();
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const glm::dvec2 uv = low + glm::dvec2(i, j) / static_cast<double>(cells) * (high - low);
      mesh->vertices.push_back(lift(uv));
      mesh->vertices.back().uv = uv;
    }
  const auto at = [&](int i, int j) { return static_cast<unsigned>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      mesh->triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Once round the z axis for u over `turns`: half a turn, or a whole one.
Vertex on_cylinder(const glm::dvec2& uv, double turns) {
  const double phi = 2 * pi * turns * uv.x;
  Vertex vertex;
  vertex.normal = {std::cos(phi), std::sin(phi), 0};
  vertex.tangent = {-std::sin(phi), std::cos(phi), 0};
  vertex.position = vertex.normal + glm::dvec3(0, 0, uv.y);
  return vertex;
}

constexpr double radius = 2, tube = 0.5, repeats = 3;

/// A torus on which the texture repeats three times along u.
Vertex on_torus(const glm::dvec2& uv) {
  const double phi = 2 * pi * uv.x / repeats, psi = 2 * pi * uv.y;
  Vertex vertex;
  vertex.normal = {std::cos(phi) * std::cos(psi), std::sin(phi) * std::cos(psi), std::sin(psi)};
  vertex.tangent = {-std::sin(phi), std::cos(phi), 0};
  vertex.position = radius * glm::dvec3(std::cos(phi), std::sin(phi), 0) + tube * vertex.normal;
  return vertex;
}

Vertex on_plane(const glm::dvec2& uv) {
  Vertex vertex;
  vertex.position = {2 * uv.x, 3 * uv.y, 0};
  return vertex;
}

SceneObject wearing(std::shared_ptr<const Mesh> mesh, int width, int height) {
  SceneObject object;
  object.name = "thing";
  object.mesh = std::move(mesh);
  object.normals = samples::normals(width, height, 3);
  return object;
}

const TextureChart::Agree never = [](const SurfaceTexel&, const SurfaceTexel&) -> bool { throw std::logic_error("asked"); };

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
    CHECK(error.text().try_this.find("the remedy") != std::string::npos);
    return error.text().what + ": " + error.text().why;
  }
  return "accepted";
}

TEST_CASE("a chart knows the frame and the derivatives of a torus under every texel, over all repeats") {
  const SceneObject object = wearing(sheet(96, {0, 0}, {repeats, 1}, on_torus), 64, 128);
  const TextureChart chart(object, *object.normals, never, "the remedy");
  CHECK(chart.width() == 192);
  CHECK(chart.height() == 128);
  CHECK(chart.repeats() == glm::dvec2(3, 1));
  CHECK(chart.wrap_u() == WrapMode::repeat);
  CHECK(chart.wrap_v() == WrapMode::repeat);
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const int x = static_cast<int>(random() % 192), y = static_cast<int>(random() % 128);
    const SurfaceTexel found = chart.at(x, y);
    const glm::dvec2 uv{(x + 0.5) / 64, (y + 0.5) / 128};
    REQUIRE(glm::length(found.uv - uv) < 1e-12);
    const Vertex exact = on_torus(uv);
    // A cell spans 3.75 degrees: the chord's middle is off by 5e-4 of the radius.
    REQUIRE(glm::length(found.position - exact.position) < 2.5e-3);
    REQUIRE(glm::length(found.frame[2] - exact.normal) < 2e-3);
    REQUIRE(glm::length(found.frame[0] - exact.tangent) < 2e-3);
    REQUIRE(glm::length(found.frame[1] - glm::cross(found.frame[2], found.frame[0])) < 1e-12);
    // Derivatives of the torus, in closed form; a flat triangle has those of a point up to half a cell away.
    const double psi = 2 * pi * uv.y, reach = radius + tube * std::cos(psi);
    const glm::dvec3 along_u = 2 * pi / repeats * reach * exact.tangent;
    const glm::dvec3 along_v = 2 * pi * tube * glm::cross(exact.normal, exact.tangent);
    REQUIRE(glm::length(found.along_u - along_u) < 0.08 * glm::length(along_u));
    REQUIRE(glm::length(found.along_v - along_v) < 0.08 * glm::length(along_v));
  }
}

TEST_CASE("a chart of a sphere has its normals, from pole to pole") {
  // The sample's triangles leave no gap at the poles, where its texture clamps.
  SceneObject object = wearing(samples::sphere(48), 128, 128);
  auto clamped = std::make_shared<Texture>(*object.normals);
  clamped->wrap_v = WrapMode::clamp;
  object.normals = clamped;
  const TextureChart chart(object, *object.normals, never, "the remedy");
  CHECK(chart.wrap_u() == WrapMode::repeat);
  CHECK(chart.wrap_v() == WrapMode::clamp);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const double phi = 2 * pi * (x + 0.5) / 128, theta = pi * (1 - (y + 0.5) / 128);
      const glm::dvec3 n{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      REQUIRE(glm::length(chart.at(x, y).frame[2] - n) < 6e-3);
    }
}

TEST_CASE("every texel of a sheet belongs to one triangle, however its edges lie") {
  std::mt19937 random(8);
  for (int trial = 0; trial < 30; ++trial) {
    auto mesh = sheet(1 + trial, {0, 0}, {1, 1}, on_plane);
    // Corners on texel centres, on borders, and anywhere.
    for (Vertex& vertex : mesh->vertices) {
      const bool border = vertex.uv.x == 0 || vertex.uv.x == 1 || vertex.uv.y == 0 || vertex.uv.y == 1;
      if (!border && trial % 3 == 1) vertex.uv = (glm::floor(vertex.uv * 128.0) + 0.5) / 128.0;
      if (!border && trial % 3 == 2) vertex.uv += glm::dvec2(random() % 100, random() % 100) * 1e-4;
      vertex.position = on_plane(vertex.uv).position;
    }
    const SceneObject object = wearing(mesh, 128, 128);
    const TextureChart chart(object, *object.normals, never, "the remedy");
    for (int i = 0; i < 500; ++i) {
      const int x = static_cast<int>(random() % 128), y = static_cast<int>(random() % 128);
      REQUIRE(glm::length(chart.at(x, y).position - glm::dvec3((x + 0.5) / 64, 3 * (y + 0.5) / 128, 0)) < 1e-9);
    }
  }
}

TEST_CASE("texels outside every triangle take the surface of the nearest texel inside") {
  // A quarter of the texture, in its middle, on a plane that tells where it is.
  SceneObject object = wearing(sheet(4, {0.25, 0.25}, {0.75, 0.75}, on_plane), 128, 128);
  auto clamped = std::make_shared<Texture>(*object.normals);
  clamped->wrap_u = clamped->wrap_v = WrapMode::clamp;
  for (const WrapMode wrap : {WrapMode::clamp, WrapMode::repeat}) {
    clamped->wrap_u = clamped->wrap_v = wrap;
    const TextureChart chart(object, *clamped, never, "the remedy");
    for (int x = 0; x < 128; ++x) {
      const int nearest = std::min(std::max(x, 32), 95);
      REQUIRE(chart.at(x, 60).position.x == Approx((nearest + 0.5) / 64));
      REQUIRE(chart.at(x, 60).uv.x == Approx((x + 0.5) / 128));
      REQUIRE(chart.at(60, x).position.y == Approx(3 * (nearest + 0.5) / 128));
    }
  }
}

TEST_CASE("a map repeats over its border only if the surface closes there") {
  const auto wrap_of = [](double turns) {
    const SceneObject object = wearing(sheet(32, {0, 0}, {1, 1}, [&](const glm::dvec2& uv) { return on_cylinder(uv, turns); }), 128, 128);
    return TextureChart(object, *object.normals, never, "the remedy").wrap_u();
  };
  CHECK(wrap_of(1) == WrapMode::repeat);
  CHECK(wrap_of(0.5) == WrapMode::clamp);
  CHECK(wrap_of(0.9) == WrapMode::clamp);
}

TEST_CASE("a map that two places of a surface share is made only if it suits both") {
  // Two sheets on the same texture, the second bent over by a quarter turn.
  auto mesh = sheet(2, {0, 0}, {1, 1}, on_plane);
  const auto bent = sheet(2, {0, 0}, {1, 1}, [](const glm::dvec2& uv) {
    Vertex vertex;
    vertex.position = {5, 3 * uv.y, 2 * uv.x};
    vertex.normal = {-1, 0, 0};
    vertex.tangent = {0, 0, 1};
    return vertex;
  });
  const auto first = static_cast<unsigned>(mesh->vertices.size());
  mesh->vertices.insert(mesh->vertices.end(), bent->vertices.begin(), bent->vertices.end());
  for (const glm::uvec3& triangle : bent->triangles) mesh->triangles.push_back(triangle + first);
  const SceneObject object = wearing(mesh, 128, 128);
  const auto bake = [&](const SurfaceNormal& normal) {
    return refusal([&] { bake_surface_map(object, *object.normals, normal, "the remedy"); });
  };
  CHECK_THAT(bake([](const SurfaceTexel& at) { return at.frame[2]; }), Catch::Contains("'thing'") && Catch::Contains("two places"));
  CHECK(bake([](const SurfaceTexel&) { return glm::dvec3(0, 0, 1); }) == "accepted");
}

TEST_CASE("maps without a surface, and maps without end, are refused") {
  const auto refused = [](const glm::dvec2& low, const glm::dvec2& high) {
    const SceneObject object = wearing(sheet(1, low, high, on_plane), 128, 128);
    return refusal([&] { TextureChart(object, *object.normals, never, "the remedy"); });
  };
  CHECK_THAT(refused({0.5, 0.5}, {0.5, 0.9}), Catch::Contains("span no area"));
  CHECK_THAT(refused({-20, 0}, {20, 30}), Catch::Contains("repeats 40 x 30 times"));
  CHECK_THAT(refused({-1e200, 0}, {1e200, 1}), Catch::Contains("too large"));
}

TEST_CASE("a coarse map is refined, since the surface curves between its texels") {
  const SceneObject object = wearing(samples::sphere(16), 1, 3);
  const TextureChart chart(object, *object.normals, never, "the remedy");
  CHECK(chart.width() == 128);
  CHECK(chart.height() == 192);
}

TEST_CASE("levels of a baked map are means of its normals, made unit") {
  const SceneObject object = wearing(samples::sphere(24), 128, 128);
  const SurfaceMap map = bake_surface_map(
      object, *object.normals, [](const SurfaceTexel& at) { return at.frame[2]; }, "the remedy");
  REQUIRE(map.normals.levels.size() == 8);
  for (const TextureLevel& level : map.normals.levels)
    for (std::size_t i = 0; i < level.texels.size(); i += 3)
      REQUIRE(glm::length(glm::dvec3(level.texels[i], level.texels[i + 1], level.texels[i + 2])) == Approx(1).margin(1e-12));
  // Eight texels of a coarse level, 45 degrees of longitude each.
  const TextureLevel& coarse = map.normals.levels[4];
  REQUIRE(coarse.width == 8);
  for (std::size_t x = 0; x < 8; ++x)
    for (std::size_t y = 0; y < 8; ++y) {
      const double* n = &coarse.texels[(y * 8 + x) * 3];
      const double phi = 2 * pi * (static_cast<double>(x) + 0.5) / 8;
      CHECK(n[0] * std::sin(phi) - n[1] * std::cos(phi) == Approx(0).margin(1e-2));
      CHECK(n[0] * std::cos(phi) + n[1] * std::sin(phi) > 0);
    }
}

}  // namespace
}  // namespace bump
