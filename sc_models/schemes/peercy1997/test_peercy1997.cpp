#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/error.h"
#include "datapath/inventory.h"
#include "datapath/vertex_program.h"
#include "schemes/peercy1997/surface_maps.h"
#include "testbench/tests/schemes/scheme_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

void require_counts(const Netlist& netlist, int multipliers, int adders, int dividers, int square_roots, int tables) {
  const Inventory c = count(netlist, Portion::published);
  CHECK(c.multipliers == multipliers);
  CHECK(c.adders == adders);
  CHECK(c.dividers == dividers);
  CHECK(c.square_roots == square_roots);
  CHECK(c.tables == tables);
  CHECK(c.maps == 0);
}

}  // namespace

TEST_CASE("Peercy 1997 is built of the operators that Table 1 of Lee 2007 charges it") {
  require_counts(designed("peercy1997").environment, 27, 18, 9, 3, 0);
  require_counts(designed("peercy1997", {{"transform", "vertex"}}).environment, 9, 6, 9, 3, 0);
  for (const char* transform : {"pixel", "vertex"})
    require_counts(designed("peercy1997", {{"transform", transform}}).illumination, 7, 5, 0, 0, 1);
}

TEST_CASE("a reciprocal root table replaces the dividers of Peercy 1997 by multipliers") {
  require_counts(designed("peercy1997", {{"normaliser", "table"}}).environment, 36, 18, 0, 0, 3);
  require_counts(designed("peercy1997", {{"normaliser", "table"}, {"transform", "vertex"}}).environment, 18, 6, 0, 0, 3);
}

TEST_CASE("Peercy 1997 interpolates five vectors, or two when the vertices transform") {
  CHECK(designed("peercy1997").interpolants.size() == 15);
  CHECK(designed("peercy1997", {{"transform", "vertex"}}).interpolants.size() == 6);
}

TEST_CASE("Peercy 1997 in double precision is the illumination equation") {
  const Material material;
  for (const char* transform : {"pixel", "vertex"})
    for (const char* normaliser : {"divider", "table"}) {
      const Design design = designed("peercy1997", {{"transform", transform}, {"normaliser", normaliser}}, material);
      CHECK(accuracy(design, material, 8, [](Random& r) { return r.point(); }).real_to_exact_db > 250);
      const auto unlit_and_mirrored = [](Random& r) {
        Point p = r.point();
        p.light *= -7;  // a point light at some distance, behind the surface
        p.view *= 0.2;
        p.binormal = -p.binormal;
        return p;
      };
      CHECK(accuracy(design, material, 8, unlit_and_mirrored).real_to_exact_db > 250);
    }
}

TEST_CASE("Peercy 1997 normalises shortened vectors") {
  const Design design = designed("peercy1997", {{"transform", "vertex"}});
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Random random(5);
    Planes planes;
    std::vector<glm::dvec3> light;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      light.push_back(random.direction());
      const double length = random.uniform(0.5, 1);  // as interpolation and filtering leave it
      for (const std::string name : {"L_ts", "H_ts", "map"}) {
        planes[name + ".x"][i] = length * light.back().x;
        planes[name + ".y"][i] = length * light.back().y;
        planes[name + ".z"][i] = length * light.back().z;
      }
    }
    run(design.environment, arithmetic, planes);
    const double tolerance = arithmetic == Arithmetic::real ? 1e-6 : 0.25;
    for (std::size_t i = 0; i < light.size(); ++i)
      for (const std::string name : {"L_unit", "H_unit", "N_unit"})
        CHECK(degrees_between(glm::normalize(glm::dvec3(planes[name + ".x"][i], planes[name + ".y"][i], planes[name + ".z"][i])),
                              light[i]) < tolerance);
  }
}

TEST_CASE("Peercy 1997 with a map in object space has the pixel hardware of the transform at the vertices, and vertices without a frame") {
  for (const char* transform : {"pixel", "vertex"}) {
    const Design design = designed("peercy1997", {{"map", "object_space"}, {"transform", transform}});
    require_counts(design.environment, 9, 6, 9, 3, 0);
    require_counts(design.illumination, 7, 5, 0, 0, 1);
    require_counts(design.vertex, 9, 9, 9, 3, 0);
    CHECK(design.interpolants.size() == 6);
    for (const Netlist::Port& port : design.vertex.inputs()) CHECK((port.name[0] == 'L' || port.name[0] == 'V'));
    CHECK(design.map.in_object_space);
    CHECK(design.map.bake);
  }
  require_counts(designed("peercy1997", {{"transform", "vertex"}}).vertex, 27, 21, 9, 3, 0);
  require_counts(designed("peercy1997", {{"map", "object_space"}, {"normaliser", "table"}}).environment, 18, 6, 0, 0, 3);
}

TEST_CASE("what Peercy 1997 stores in a tangent-space map changes no hardware") {
  for (const char* transform : {"pixel", "vertex"}) {
    const Design scene_map = designed("peercy1997", {{"transform", transform}});
    const Design own_map = designed("peercy1997", {{"transform", transform}, {"perturbation", "surface"}});
    CHECK(count(own_map.environment).multipliers == count(scene_map.environment).multipliers);
    CHECK(own_map.interpolants.size() == scene_map.interpolants.size());
    CHECK(!own_map.map.in_object_space);
    CHECK(own_map.map.bake);
    CHECK(!scene_map.map.bake);
  }
}

TEST_CASE("Peercy 1997 in object space is the illumination equation, and keeps 50 dB in fixed point") {
  const Material material;
  const Design design = designed("peercy1997", {{"map", "object_space"}}, material);
  const auto along_the_axes = [](Random& r) {
    Point p = r.point();
    p.normal = {0, 0, 1};
    p.tangent = {1, 0, 0};
    p.binormal = {0, 1, 0};
    p.bump = r.direction();  // any direction is a normal in object space
    return p;
  };
  const Accuracy found = accuracy(design, material, 20, along_the_axes);
  CHECK(found.real_to_exact_db > 250);
  CHECK(found.fixed_to_real_db > 50);
}

namespace {

/// A parallelogram P = u Pu + v Pv with random heights; mirrored if Pu x Pv points inside.
SceneObject parallelogram(const glm::dvec3& pu, const glm::dvec3& pv, const glm::dvec3& normal, int width, int height) {
  SceneObject object;
  object.name = "patch";
  auto mesh = std::make_shared<Mesh>();
  for (const glm::dvec2 uv : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
    Vertex vertex;
    vertex.uv = uv;
    vertex.position = uv.x * pu + uv.y * pv;
    vertex.normal = normal;
    vertex.tangent = glm::normalize(pu);
    vertex.handedness = glm::dot(glm::cross(pu, pv), normal) < 0 ? -1 : 1;
    mesh->vertices.push_back(vertex);
  }
  mesh->triangles = {{0, 1, 3}, {0, 3, 2}};
  object.mesh = mesh;
  Random random(3);
  auto heights = std::make_shared<Texture>();
  heights->channels = 1;
  heights->kinds = {ChannelKind::linear};
  heights->levels.push_back({width, height, {}});
  for (int i = 0; i < width * height; ++i) heights->levels[0].texels.push_back(random.uniform(0, 3));
  object.heights = heights;
  auto normals = std::make_shared<Texture>(*heights);
  normals->channels = 3;
  normals->kinds.assign(3, ChannelKind::linear);
  normals->levels[0].texels.clear();
  for (int i = 0; i < width * height; ++i) {
    const glm::dvec3 n = random.point(0.8).bump;
    normals->levels[0].texels.insert(normals->levels[0].texels.end(), {n.x, n.y, n.z});
  }
  object.normals = normals;
  return object;
}

glm::dvec3 texel_of(const Texture& texture, int x, int y) {
  const TextureLevel& level = texture.levels[0];
  const double* t = &level.texels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x))];
  return {t[0], t[1], t[2]};
}

}  // namespace

TEST_CASE("maps of Peercy 1997 for a surface hold Blinn's normal, in tangent and in object space") {
  using namespace peercy1997;
  constexpr int width = 128, height = 256;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.9));
  const glm::dvec3 a = glm::normalize(glm::cross(normal, glm::dvec3(1, 2, 3))), b = glm::cross(normal, a);
  const glm::dvec3 pu = 2.0 * a, leaning = 0.7 * a + 1.5 * b;
  for (const glm::dvec3& pv : {leaning, -leaning, 2.0 * b, 0.4 * b}) {
    const SceneObject object = parallelogram(pu, pv, normal, width, height);
    const Texture tangent = surface_map(object, MapSpace::tangent, Perturbation::surface).normals;
    const Texture in_object = surface_map(object, MapSpace::object, Perturbation::surface).normals;
    const std::vector<double>& h = object.heights->levels[0].texels;
    const auto at = [&](int x, int y) { return h[static_cast<std::size_t>((y + height) % height * width + (x + width) % width)]; };
    // Heights are in texels; one is as long as the mean side of a texel on the surface.
    const double side = std::sqrt(glm::length(glm::cross(pu, pv)) / (width * height));
    const glm::dvec3 t = glm::normalize(pu), bi = (glm::dot(glm::cross(pu, pv), normal) < 0 ? -1.0 : 1.0) * glm::cross(normal, t);
    Random random(4);
    for (int i = 0; i < 300; ++i) {
      const int x = static_cast<int>(random.word() % width), y = static_cast<int>(random.word() % height);
      const double fu = side * (at(x + 1, y) - at(x - 1, y)) / 2 * width, fv = side * (at(x, y + 1) - at(x, y - 1)) / 2 * height;
      // Peercy 1997, Eqs 1 and 2, outwards: the perturbed surface P + f N, whose normal is the cross product of its derivatives.
      const glm::dvec3 perturbed = glm::normalize(glm::cross(pu + fu * normal, pv + fv * normal));
      const glm::dvec3 outwards = glm::dot(perturbed, normal) < 0 ? -perturbed : perturbed;
      REQUIRE(glm::length(texel_of(in_object, x, y) - outwards) < 1e-9);
      REQUIRE(glm::length(texel_of(tangent, x, y) - glm::dvec3(glm::dot(outwards, t), glm::dot(outwards, bi), glm::dot(outwards, normal))) <
              1e-9);
    }
  }
}

TEST_CASE("on square texels Eqs 3-6 of Peercy 1997 are Eqs 8-11 with k one texel") {
  using namespace peercy1997;
  const SceneObject object = parallelogram({3, 0, 0}, {0, 3, 0}, {0, 0, 1}, 128, 128);
  const Texture map = surface_map(object, MapSpace::tangent, Perturbation::surface).normals;
  const std::vector<double>& h = object.heights->levels[0].texels;
  const auto at = [&](int x, int y) { return h[static_cast<std::size_t>((y + 128) % 128 * 128 + (x + 128) % 128)]; };
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const glm::dvec3 square = glm::normalize(glm::dvec3((at(x - 1, y) - at(x + 1, y)) / 2, (at(x, y - 1) - at(x, y + 1)) / 2, 1));
      REQUIRE(glm::length(texel_of(map, x, y) - square) < 1e-9);
    }
}

TEST_CASE("an object-space map of Peercy 1997 turns the scene's own normals, and a surface without relief needs no heights") {
  using namespace peercy1997;
  SceneObject object = parallelogram({0, 3, 0}, {0, 0, 2}, {1, 0, 0}, 128, 128);
  const Texture turned = surface_map(object, MapSpace::object, Perturbation::square_patch).normals;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const glm::dvec3 n = texel_of(*object.normals, x, y);
      REQUIRE(glm::length(texel_of(turned, x, y) - glm::dvec3(n.z, n.x, n.y)) < 1e-9);
    }
  object.heights = nullptr;
  for (const MapSpace space : {MapSpace::tangent, MapSpace::object})
    CHECK_THROWS_WITH(surface_map(object, space, Perturbation::surface),
                      Catch::Contains("'patch'") && Catch::Contains("without heights") && Catch::Contains("perturbation=square_patch"));
  auto flat = std::make_shared<Texture>(*object.normals);
  for (std::size_t i = 0; i < flat->levels[0].texels.size(); ++i) flat->levels[0].texels[i] = i % 3 == 2 ? 1 : 0;
  object.normals = flat;
  CHECK(texel_of(surface_map(object, MapSpace::tangent, Perturbation::surface).normals, 5, 5) == glm::dvec3(0, 0, 1));
  CHECK(glm::length(texel_of(surface_map(object, MapSpace::object, Perturbation::surface).normals, 5, 5) - glm::dvec3(1, 0, 0)) < 1e-12);
}

TEST_CASE("Peercy 1997 gains six decibels a bit") {
  const Material material;
  const auto db = [&](const char* bits) {
    const Design design = designed("peercy1997", {{"word_bits", bits}, {"texel_bits", bits}, {"light_table_bits", "12"}}, material);
    return accuracy(design, material, 20, [](Random& r) { return r.point(); }).fixed_to_exact_db;
  };
  const double eight = db("8"), ten = db("10"), twelve = db("12");
  CHECK(eight > 33);
  CHECK(ten - eight == Approx(12).margin(3));
  CHECK(twelve - ten == Approx(12).margin(3));
}

TEST_CASE("fixed point keeps Peercy 1997 above 50 dB at its defaults") {
  const Material material;
  for (const char* transform : {"pixel", "vertex"})
    for (const char* normaliser : {"divider", "table"}) {
      const Design design = designed("peercy1997", {{"transform", transform}, {"normaliser", normaliser}}, material);
      CHECK(accuracy(design, material, 30, [](Random& r) { return r.point(); }).fixed_to_real_db > 50);
    }
}
