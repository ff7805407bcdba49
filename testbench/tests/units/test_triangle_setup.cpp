// Triangle setup: clipping, culling, snapping and what becomes of the attributes.

#include <catch2/catch.hpp>
#include <cmath>

#include "samples.h"
#include "units/projection.h"

namespace bump {
namespace {

/// Runs one triangle with given corners in world space through vertex processor and setup.
struct OneTriangle {
  Scene scene;
  std::shared_ptr<const PipelineContext> context;
  TriangleBlock block;
  GeometryCounters counters;

  OneTriangle(const std::array<glm::dvec3, 3>& corners, const TriangleSetupConfig& config = {},
              const std::array<glm::dvec3, 3>& normals = {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1)}) {
    auto mesh = std::make_shared<Mesh>();
    for (std::size_t i = 0; i < 3; ++i) {
      Vertex v;
      v.position = corners[i];
      v.normal = normals[i];
      v.uv = {corners[i].x, corners[i].y};
      mesh->vertices.push_back(v);
    }
    mesh->triangles.push_back({0, 1, 2});
    scene = samples::scene({samples::object(mesh)});
    context = samples::context(scene);
    VertexProcessor vertices(context, {});
    vertices.next(block);
    TriangleSetup setup(context, config);
    setup.process(block);
    counters = setup.counters();
  }
};

TEST_CASE("corners snap to the nearest point of the subpixel grid") {
  std::mt19937 random(31);
  const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 1000.0 - 1; };
  for (const int bits : {1, 4, 8, 12}) {
    TriangleSetupConfig config;
    config.subpixel_bits = bits;
    config.cull_back = false;
    for (int trial = 0; trial < 50; ++trial) {
      const OneTriangle one(
          {glm::dvec3(coordinate(), coordinate(), 0), glm::dvec3(coordinate(), coordinate(), 0), glm::dvec3(coordinate(), coordinate(), 0)},
          config);
      for (const auto& piece : one.block.pieces) {
        for (std::size_t c = 0; c < 3; ++c) {
          const ScreenPosition at = to_screen(one.block.clip[c], one.scene.width, one.scene.height);
          REQUIRE(std::fabs(piece->x[c] - at.x) <= std::ldexp(0.5, -bits));
          REQUIRE(std::fabs(piece->y[c] - at.y) <= std::ldexp(0.5, -bits));
          REQUIRE(std::ldexp(piece->x[c], bits) == std::floor(std::ldexp(piece->x[c], bits)));
          REQUIRE(piece->depth[c] == at.depth);
          REQUIRE(piece->inverse_w[c] == at.inverse_w);
        }
      }
    }
  }
}

TEST_CASE("a triangle is drawn from the front, culled from behind unless both sides are wanted, and dropped without area") {
  const std::array<glm::dvec3, 3> front = {glm::dvec3(-0.5, -0.5, 0), glm::dvec3(0.5, -0.5, 0), glm::dvec3(0, 0.5, 0)};
  const std::array<glm::dvec3, 3> back = {front[0], front[2], front[1]};
  const std::array<glm::dvec3, 3> line = {front[0], front[1], front[0]};
  CHECK(OneTriangle(front).block.pieces.size() == 1);
  CHECK(twice_area(*OneTriangle(front).block.pieces.front(), 8) < 0);
  CHECK(OneTriangle(back).block.pieces.empty());
  CHECK(OneTriangle(back).counters.triangles_culled == 1);
  CHECK(OneTriangle(line).block.pieces.empty());
  CHECK(OneTriangle(line).counters.triangles_empty == 1);
  CHECK(OneTriangle(line).counters.triangles_culled == 0);
  // Beside the frame both sides are empty: nothing is asked about their facing.
  for (const auto& corners : {front, back}) {
    std::array<glm::dvec3, 3> beside = corners;
    for (glm::dvec3& corner : beside) corner.x += 20;
    CHECK(OneTriangle(beside).counters.triangles_empty == 1);
    CHECK(OneTriangle(beside).counters.triangles_culled == 0);
  }
  TriangleSetupConfig both;
  both.cull_back = false;
  CHECK(OneTriangle(back, both).block.pieces.size() == 1);
}

TEST_CASE("a triangle that crosses the near plane is cut into one or two, all in front of it, and stays one token") {
  TriangleSetupConfig config;
  config.interval = 3;
  config.cull_back = false;
  // The eye is at z = 3; these corners lie behind it.
  const OneTriangle quad({glm::dvec3(-1, -0.5, 0), glm::dvec3(1, -0.5, 0), glm::dvec3(0, -0.5, 5)}, config);
  CHECK(quad.block.pieces.size() == 2);
  const OneTriangle tip({glm::dvec3(-1, -0.5, 5), glm::dvec3(1, -0.5, 5), glm::dvec3(0, -0.5, 0)}, config);
  CHECK(tip.block.pieces.size() == 1);
  const OneTriangle behind({glm::dvec3(-1, -0.5, 5), glm::dvec3(1, -0.5, 5), glm::dvec3(0, -0.5, 4)}, config);
  CHECK(behind.block.pieces.empty());
  for (const OneTriangle* one : {&quad, &tip, &behind}) {
    const std::size_t pieces = one->block.pieces.size();
    REQUIRE(one->block.setup_records.size() == 1);
    CHECK(one->block.setup_records[0].interval == 3 * std::max<std::size_t>(1, pieces));
    CHECK(one->counters.triangles_clipped == (pieces > 0 ? 1 : 0));
    for (const auto& piece : one->block.pieces) {
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(piece->inverse_w[c] > 0);
        CHECK(1 / piece->inverse_w[c] >= one->scene.camera.near * (1 - 1e-9));
        CHECK(piece->depth[c] >= -1e-6);
        // The texture coordinates were the world position: cut corners still lie on the plane, at their own place.
        CHECK(std::fabs(piece->attributes[c * piece->attributes.size() / 3 + 1] + 0.5) < 1e-9);
      }
    }
  }
}

TEST_CASE("nothing beyond the guard band is left, and nothing inside the frame changes") {
  const std::array<glm::dvec3, 3> large = {glm::dvec3(-40, -30, 0), glm::dvec3(50, -20, 0), glm::dvec3(3, 60, 0)};
  TriangleSetupConfig tight;
  tight.guard_band = 4;
  const OneTriangle cut(large, tight), whole(large);
  CHECK(whole.block.pieces.size() == 1);
  CHECK(whole.counters.triangles_clipped == 0);
  REQUIRE(cut.block.pieces.size() >= 2);
  CHECK(cut.counters.triangles_clipped == 1);
  std::vector<int> count(static_cast<std::size_t>(cut.scene.width * cut.scene.height), 0);
  for (const auto& piece : cut.block.pieces) {
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(piece->x[c] >= -4.01);
      CHECK(piece->x[c] <= cut.scene.width + 4.01);
      CHECK(piece->y[c] >= -4.01);
      CHECK(piece->y[c] <= cut.scene.height + 4.01);
    }
    const EdgeFunctions edges(*piece, 8);
    for (int y = 0; y < cut.scene.height; ++y) {
      const PixelSpan span = edges.span(y, 0, cut.scene.width - 1);
      for (int x = span.first; x <= span.last; ++x) ++count[static_cast<std::size_t>(y * cut.scene.width + x)];
    }
  }
  CHECK(std::count(count.begin(), count.end(), 1) == cut.scene.width * cut.scene.height);
}

TEST_CASE("angles go the short way from the first corner and flat angles take its value") {
  // turn = 0.5 n.x, flat = 0.5 n.y of the (here not unit) normals.
  const std::array<glm::dvec3, 3> front = {glm::dvec3(-0.5, -0.5, 0), glm::dvec3(0.5, -0.5, 0), glm::dvec3(0, 0.5, 0)};
  const OneTriangle one(front, {}, {glm::dvec3(0.9, 0.2, 1), glm::dvec3(-0.9, 0.4, 1), glm::dvec3(0.7, -0.6, 1)});
  REQUIRE(one.block.pieces.size() == 1);
  const std::vector<double>& values = one.block.pieces[0]->attributes;
  const std::size_t stride = values.size() / 3;
  std::size_t turn = 0, flat = 0;
  for (std::size_t a = 0; a < one.context->attributes.size(); ++a) {
    if (one.context->attributes[a].kind == InterpolantKind::angle) turn = 2 + a;
    if (one.context->attributes[a].kind == InterpolantKind::flat_angle) flat = 2 + a;
  }
  CHECK(values[turn] == Approx(0.45));
  CHECK(values[stride + turn] == Approx(0.55));  // -0.45, the short way
  CHECK(values[2 * stride + turn] == Approx(0.35));
  for (std::size_t c = 0; c < 3; ++c) CHECK(values[c * stride + flat] == Approx(0.1));
}

TEST_CASE("screen coordinates that would not fit the edge functions are refused") {
  Scene scene = samples::scene({samples::object(samples::plane(1))}, 300000, 1);
  TriangleSetupConfig config;
  config.subpixel_bits = 12;
  CHECK_THROWS_AS(TriangleSetup(samples::context(scene), config), Error);
}

}  // namespace
}  // namespace bump
