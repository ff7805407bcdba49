// The rasterizer: what is covered is hidden or shaded, tokens tell the story, and weights are those of the ray through the pixel.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "samples.h"
#include "units/projection.h"

namespace bump {
namespace {

using Order = RasterizerConfig::Order;

RasterizerConfig order(Order which, int tile = 8, bool early_z = true) {
  RasterizerConfig config;
  config.order = which;
  config.tile = tile;
  config.early_z = early_z;
  return config;
}

/// Nearest object at every pixel, after all fragments in order.
std::vector<int> picture(const Scene& scene, const samples::Geometry& geometry) {
  const std::size_t pixels = static_cast<std::size_t>(scene.width * scene.height);
  std::vector<double> depth(pixels, 1);
  std::vector<int> object(pixels, -1);
  for (const auto& block : geometry.blocks) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      const auto at = static_cast<std::size_t>(block->y[lane] * scene.width + block->x[lane]);
      if (!(block->depth[lane] < depth[at])) continue;
      depth[at] = block->depth[lane];
      object[at] = block->object;
    }
  }
  return object;
}

TEST_CASE("every covered position is hidden or shaded, in any order, and the picture is the same") {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  const samples::Geometry late = samples::rasterize(context, order(Order::scanline, 8, false));
  const std::vector<int> expected = picture(scene, late);
  CHECK(late.raster.fragments_hidden == 0);
  CHECK(late.raster.fragments == late.raster.fragments_generated);
  for (const RasterizerConfig& config :
       {order(Order::scanline), order(Order::tiled, 1), order(Order::tiled, 5), order(Order::tiled, 256)}) {
    const samples::Geometry geometry = samples::rasterize(context, config);
    CHECK(geometry.raster.fragments_generated == late.raster.fragments_generated);
    CHECK(geometry.raster.fragments_hidden + geometry.raster.fragments == geometry.raster.fragments_generated);
    CHECK(geometry.raster.fragments_hidden > 0);
    CHECK(picture(scene, geometry) == expected);
  }
}

TEST_CASE("each triangle is one token to take and one to release, its intervals are the positions scanned") {
  const Scene scene = samples::crowded_scene(150, 100);
  const auto context = samples::context(scene);
  for (const bool early_z : {true, false}) {
    const samples::Geometry geometry = samples::rasterize(context, order(Order::scanline, 8, early_z));
    std::int64_t released = 0, given = 0, scanned = 0, ghosts = 0, lanes = 0, vertex_records = 0, setup_records = 0;
    bool open = false;
    for (const auto& block : geometry.blocks) {
      CHECK(block->last == (block == geometry.blocks.back()));
      lanes += block->lanes;
      vertex_records += static_cast<std::int64_t>(block->vertex_records.size());
      setup_records += static_cast<std::int64_t>(block->setup_records.size());
      std::int64_t given_here = 0;
      for (const TokenRecord& record : block->raster_records) {
        REQUIRE(record.take == 1);
        REQUIRE(record.interval >= 1);
        REQUIRE(record.interval > record.lead);
        if (record.give == 0) {
          REQUIRE((!open && record.release == 1));
          ++ghosts;
        } else {
          scanned += record.interval;
          ++given_here;
        }
        open = record.release == 0;
        released += record.release;
      }
      REQUIRE(given_here == block->lanes);
      given += given_here;
      // A triangle leaves its records in front of its fragments.
      REQUIRE(setup_records >= released + (open ? 1 : 0));
    }
    CHECK(!open);
    CHECK(released == context->triangles());
    CHECK(vertex_records == context->triangles());
    CHECK(setup_records == context->triangles());
    CHECK(given == geometry.raster.fragments);
    CHECK(lanes == geometry.raster.fragments);
    CHECK(ghosts > 0);
    if (!early_z) CHECK(scanned == geometry.raster.fragments);
    if (early_z) CHECK((scanned > geometry.raster.fragments && scanned <= geometry.raster.fragments_generated));
  }
}

TEST_CASE("a hidden triangle passes as a ghost that costs its positions") {
  // The same plane twice: nothing of the second is nearer, so ties go to the first.
  const Scene scene = samples::scene({samples::object(samples::plane(1)), samples::object(samples::plane(1))});
  const samples::Geometry geometry = samples::rasterize(samples::context(scene));
  CHECK(geometry.raster.fragments_hidden == geometry.raster.fragments);
  CHECK(geometry.raster.triangles_hidden == 2);
  CHECK(geometry.raster.triangles_drawn == 2);
  CHECK(geometry.raster.triangles_empty == 0);
  std::int64_t hidden = 0;
  int ghosts = 0;
  for (const auto& block : geometry.blocks) {
    CHECK((block->lanes == 0 || block->object == 0));
    for (const TokenRecord& record : block->raster_records) {
      if (record.give != 0) continue;
      ++ghosts;
      hidden += record.interval;
    }
  }
  CHECK(ghosts == 2);
  CHECK(hidden == geometry.raster.fragments_hidden);
}

TEST_CASE("every mesh triangle is culled, empty, hidden or drawn, and only hidden and drawn ask early z") {
  // Spheres in part hidden, with triangles smaller than a pixel; planes beside the frame, edge-on, and reaching behind the eye.
  Scene scene = samples::crowded_scene();
  scene.objects.push_back(samples::object(samples::sphere(60), glm::translate(glm::dmat4(1), {-0.7, 0.5, 0.2})));
  scene.objects.push_back(samples::object(samples::sphere(6), glm::translate(glm::dmat4(1), {0.0, 0.0, -1.4})));
  scene.objects.push_back(samples::object(samples::plane(2), glm::translate(glm::dmat4(1), {9.0, 0.0, 0.0})));
  scene.objects.push_back(samples::object(samples::plane(2), glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(0, 1, 0))));
  scene.objects.push_back(samples::object(
      samples::plane(1), glm::rotate(glm::translate(glm::dmat4(1), {0.0, -0.6, 1.0}), glm::radians(-90.0), glm::dvec3(1, 0, 0)) *
                             glm::scale(glm::dmat4(1), glm::dvec3(4))));
  const auto context = samples::context(scene);
  for (const bool cull : {true, false}) {
    for (const int guard : {8192, 2}) {
      TriangleSetupConfig setup;
      setup.cull_back = cull;
      setup.guard_band = guard;
      const samples::Geometry early = samples::rasterize(context, order(Order::tiled, 8, true), setup);
      const samples::Geometry late = samples::rasterize(context, order(Order::scanline, 8, false), setup);
      for (const samples::Geometry* geometry : {&early, &late}) {
        const GeometryCounters &s = geometry->setup, &r = geometry->raster;
        CHECK(geometry->vertex.triangles == context->triangles());
        CHECK(s.triangles_culled + s.triangles_empty + r.triangles_empty + r.triangles_hidden + r.triangles_drawn == context->triangles());
        std::set<std::pair<int, std::uint32_t>> drawn;
        for (const auto& block : geometry->blocks)
          for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane)
            drawn.emplace(block->object, block->triangles[static_cast<std::size_t>(block->triangle[lane])]->source);
        CHECK(r.triangles_drawn == static_cast<std::int64_t>(drawn.size()));
      }
      CHECK(early.raster.triangles_empty == late.raster.triangles_empty);
      CHECK(early.raster.triangles_empty > 0);
      CHECK(early.setup.triangles_empty == late.setup.triangles_empty);
      CHECK(early.setup.triangles_empty >= 8 + 8);
      CHECK((early.setup.triangles_culled > 0) == cull);
      CHECK(early.setup.triangles_clipped > 0);
      CHECK(early.raster.triangles_hidden > 0);
      CHECK(late.raster.triangles_hidden == 0);
      CHECK(early.raster.triangles_hidden + early.raster.triangles_drawn == late.raster.triangles_drawn);
    }
  }
}

TEST_CASE("scanline order is by rows, tiled order by tiles and by rows within") {
  const Scene scene = samples::scene({samples::object(samples::plane(1))});
  const auto context = samples::context(scene);
  for (const int tile : {0, 4, 7}) {
    const samples::Geometry geometry = samples::rasterize(context, tile ? order(Order::tiled, tile) : order(Order::scanline));
    std::map<std::uint32_t, std::array<int, 4>> previous;
    for (const auto& block : geometry.blocks) {
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
        const int x = block->x[lane], y = block->y[lane];
        const std::array<int, 4> key = tile ? std::array<int, 4>{y / tile, x / tile, y, x} : std::array<int, 4>{0, 0, y, x};
        const std::uint32_t source = block->triangles[static_cast<std::size_t>(block->triangle[lane])]->source;
        if (previous.count(source)) REQUIRE(previous[source] < key);
        previous[source] = key;
      }
    }
    CHECK(previous.size() == 2);
  }
}

TEST_CASE("blocks hold one object, are full where they can be, and each lane names its triangle") {
  const Scene scene = samples::crowded_scene(200, 150);
  const samples::Geometry geometry = samples::rasterize(samples::context(scene));
  std::map<int, int> partial;
  int object = 0;
  for (const auto& block : geometry.blocks) {
    REQUIRE(block->object >= object);
    object = block->object;
    if (block->lanes < block_lanes) ++partial[object];
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane)
      REQUIRE(static_cast<std::size_t>(block->triangle[lane]) < block->triangles.size());
  }
  for (const auto& [which, count] : partial) CHECK(count <= 1 + (which == 2 ? 1 : 0));
}

TEST_CASE("weights, texture coordinates and their derivatives are those of the ray through the pixel's centre") {
  // A strongly tilted plane: perspective matters. Subpixel bits are many, so that snapping does not.
  const glm::dmat4 tilt = glm::rotate(glm::dmat4(1), -1.2, glm::dvec3(1, 0.2, 0));
  const Scene scene = samples::scene({samples::object(samples::plane(1), tilt)});
  const auto context = samples::context(scene);
  RasterizerConfig config;
  TriangleSetupConfig setup;
  config.subpixel_bits = setup.subpixel_bits = 12;
  const samples::Geometry geometry = samples::rasterize(context, config, setup);
  const glm::dmat4 from_clip = glm::inverse(world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene)));
  const glm::dmat4 to_object = glm::inverse(tilt);
  const auto uv_at = [&](double x, double y) {
    const glm::dvec4 far = from_clip * glm::dvec4(2 * x / scene.width - 1, 1 - 2 * y / scene.height, 0.5, 1);
    const glm::dvec3 eye = glm::dvec3(to_object * glm::dvec4(scene.camera.eye, 1)),
                     through = glm::dvec3(to_object * glm::dvec4(glm::dvec3(far) / far.w, 1));
    const glm::dvec3 hit = eye + (through - eye) * (eye.z / (eye.z - through.z));
    return glm::dvec2(hit.x + 1, hit.y + 1) * 0.5;
  };
  int fragments = 0;
  for (const auto& block : geometry.blocks) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      const double x = block->x[lane] + 0.5, y = block->y[lane] + 0.5;
      const glm::dvec2 exact = uv_at(x, y);
      REQUIRE(std::fabs(block->u[lane] - exact.x) < 2e-4);
      REQUIRE(std::fabs(block->v[lane] - exact.y) < 2e-4);
      const SetupTriangle& t = *block->triangles[static_cast<std::size_t>(block->triangle[lane])];
      const std::size_t stride = t.attributes.size() / 3;
      const double w1 = block->weight1[lane], w2 = block->weight2[lane];
      REQUIRE(block->u[lane] ==
              Approx((1 - w1 - w2) * t.attributes[0] + w1 * t.attributes[stride] + w2 * t.attributes[2 * stride]).margin(1e-12));
      const double h = 0.01;
      const glm::dvec2 across = (uv_at(x + h, y) - uv_at(x - h, y)) / (2 * h), down = (uv_at(x, y + h) - uv_at(x, y - h)) / (2 * h);
      const double margin = 0.01 * std::max(glm::length(across), glm::length(down));
      REQUIRE(block->dudx[lane] == Approx(across.x).margin(margin));
      REQUIRE(block->dvdx[lane] == Approx(across.y).margin(margin));
      REQUIRE(block->dudy[lane] == Approx(down.x).margin(margin));
      REQUIRE(block->dvdy[lane] == Approx(down.y).margin(margin));
      ++fragments;
    }
  }
  CHECK(fragments > 500);
}

TEST_CASE("a mesh that fills the frame covers every pixel once, also when it is clipped") {
  for (const int guard : {8192, 3}) {
    // The plane passes behind the eye at its near side, and far beyond the frame at every other.
    Scene scene =
        samples::scene({samples::object(samples::plane(5), glm::scale(glm::translate(glm::dmat4(1), {0.0, 0.0, 1.0}), glm::dvec3(30)))});
    scene.camera.eye = {0, -0.4, 1.5};
    scene.camera.target = {0.1, 0.3, 1};
    RasterizerConfig config;
    config.early_z = false;
    TriangleSetupConfig setup;
    setup.guard_band = guard;
    const samples::Geometry geometry = samples::rasterize(samples::context(scene), config, setup);
    std::vector<int> count(static_cast<std::size_t>(scene.width * scene.height), 0);
    for (const auto& block : geometry.blocks)
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane)
        ++count[static_cast<std::size_t>(block->y[lane] * scene.width + block->x[lane])];
    CHECK(std::count(count.begin(), count.end(), 1) == scene.width * scene.height);
    if (guard == 3) CHECK(geometry.setup.triangles_clipped > 0);
  }
}

}  // namespace
}  // namespace bump
