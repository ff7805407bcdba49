// The vertex processor: values against glm, time against the cache replayed by hand.

#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>

#include "datapath/inventory.h"
#include "samples.h"
#include "units/projection.h"

namespace bump {
namespace {

TEST_CASE("the vertex cache keeps the last entries first in, first out") {
  std::mt19937 random(21);
  for (const int entries : {0, 1, 3, 16}) {
    VertexCache cache(entries, 40);
    std::deque<std::uint32_t> naive;
    bool same = true;
    for (int i = 0; i < 4000; ++i) {
      const auto vertex = static_cast<std::uint32_t>(random() % 40);
      const bool there = std::count(naive.begin(), naive.end(), vertex) > 0;
      same = same && cache.look_up(vertex) == there;
      if (there) continue;
      naive.push_back(vertex);
      if (naive.size() > static_cast<std::size_t>(entries)) naive.pop_front();
    }
    INFO(entries << " entries");
    CHECK(same);
  }
}

TEST_CASE("the clip transform is sixteen multiplications and twelve additions, and each vector three more") {
  const Inventory plain = count(vertex_transform(false, 0));
  CHECK(plain.multipliers == 16);
  CHECK(plain.adders == 12);
  CHECK(count(vertex_transform(true, 2)).adders == 12 + 3 * 3);
}

TEST_CASE("work that depends on the light is counted once per light, the rest once") {
  const Scene scene = samples::crowded_scene();
  const VertexWork work = vertex_work(*samples::context(scene));
  CHECK(work.per_light == 9 + 6);
  CHECK(work.once == 2);
  CHECK(work.transform == 28 + 3);  // one point light; nothing reads V
  CHECK(work.lights == 2);
  CHECK(work.total() == 31 + 2 + 2 * 15);
}

TEST_CASE("triangles come in mesh order, in blocks of one object, and cost the vertices that the cache does not hold") {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  for (const int entries : {0, 4, 16}) {
    VertexProcessorConfig config;
    config.cache_entries = entries;
    config.alus = 5;
    VertexProcessor unit(context, config);
    const std::int64_t per_vertex = (unit.work().total() + 4) / 5;
    TriangleBlock block;
    int object = -1;
    std::uint32_t next = 0;
    std::int64_t vertices = 0, triangles = 0;
    std::deque<std::uint32_t> held;
    while (unit.next(block)) {
      REQUIRE((block.triangles >= 1 && block.triangles <= block_triangles));
      REQUIRE(block.vertex_records.size() == static_cast<std::size_t>(block.triangles));
      if (block.object != object) {
        REQUIRE(block.object == object + 1);
        object = block.object;
        next = 0;
        held.clear();
      }
      for (int i = 0; i < block.triangles; ++i) {
        REQUIRE(block.source[static_cast<std::size_t>(i)] == next);
        std::int64_t missing = 0;
        const glm::uvec3 corners = scene.objects[static_cast<std::size_t>(object)].mesh->triangles[next++];
        for (int c = 0; c < 3; ++c) {
          if (std::count(held.begin(), held.end(), corners[c]) > 0) continue;
          ++missing;
          held.push_back(corners[c]);
          if (held.size() > static_cast<std::size_t>(entries)) held.pop_front();
        }
        REQUIRE(block.vertex_records[static_cast<std::size_t>(i)].interval == std::max<std::int64_t>(1, missing * per_vertex));
        vertices += missing;
        ++triangles;
      }
    }
    CHECK(triangles == context->triangles());
    CHECK(unit.counters().triangles == triangles);
    CHECK(unit.counters().vertices == vertices);
    CHECK(unit.counters().vertices + unit.counters().vertex_reuses == 3 * triangles);
    CHECK(!unit.next(block));
    CHECK(block.triangles == 0);
  }
}

TEST_CASE("corners carry the clip position, texture coordinates and the program's outputs in object space") {
  Scene scene = samples::scene(
      {samples::object(samples::sphere(6), glm::rotate(glm::scale(glm::translate(glm::dmat4(1), {0.3, -0.2, 0.1}), glm::dvec3(0.7)), 1.1,
                                                       glm::normalize(glm::dvec3(1, 2, 3))))});
  ContextOptions options;
  options.probe_directions = true;
  const auto context = samples::context(scene, options);
  VertexProcessor unit(context, {});
  const glm::dmat4 to_world = scene.objects[0].to_world;
  const glm::dmat4 to_clip = world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene)) * to_world;
  const Mesh& mesh = *scene.objects[0].mesh;
  const auto value = [&](const double* corner, const std::string& plane) {
    for (std::size_t a = 0; a < context->attributes.size(); ++a)
      if (context->planes.names()[static_cast<std::size_t>(context->attributes[a].plane)] == plane) return corner[2 + a];
    return std::nan("");
  };
  TriangleBlock block;
  while (unit.next(block)) {
    for (int i = 0; i < block.triangles; ++i) {
      for (int c = 0; c < 3; ++c) {
        const auto slot = static_cast<std::size_t>(3 * i + c);
        const Vertex& v = mesh.vertices[mesh.triangles[block.source[static_cast<std::size_t>(i)]][c]];
        const double* corner = &block.attributes[slot * static_cast<std::size_t>(block.stride)];
        REQUIRE(glm::length(block.clip[slot] - to_clip * glm::dvec4(v.position, 1)) < 1e-12);
        REQUIRE(corner[0] == v.uv.x);
        REQUIRE(corner[1] == v.uv.y);
        REQUIRE(value(corner, "n.x") == v.normal.x);
        REQUIRE(value(corner, "probe.P.z") == v.position.z);
        REQUIRE(value(corner, "turn") == 0.5 * v.normal.x);
        // Directions turn with the object; a point light's distance also scales.
        const glm::dvec3 world_normal = glm::normalize(glm::dvec3(to_world * glm::dvec4(v.normal, 0)));
        const glm::dvec3 world_position = glm::dvec3(to_world * glm::dvec4(v.position, 1));
        REQUIRE(value(corner, "l.z") == Approx(glm::dot(world_normal, scene.lights[0].vector)).margin(1e-12));
        REQUIRE(value(corner, "l.z#1") == Approx(glm::dot(world_normal, scene.lights[1].vector - world_position) / 0.7).margin(1e-12));
      }
    }
  }
}

}  // namespace
}  // namespace bump
