#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "testbench/published/lee2007_table1.h"
#include "testbench/tests/schemes/vector_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

Operators published_operators(const char* unit) {
  const published::Table1Cell* cell = published::table1_cell("ernst1998", unit);
  REQUIRE(cell != nullptr);
  const published::OperatorCounts& c = cell->counts;
  return {c.multipliers, c.adders, c.dividers, c.square_roots, c.tables, c.maps};
}

/// What the blend of the low-end engine comes to, from the vectors of the point.
double gouraud_intensity(const Point& p, const Material& material) {
  const glm::dvec3 light = glm::normalize(p.light), half = glm::normalize(light + glm::normalize(p.view));
  const double n_l = std::max(0.0, glm::dot(p.normal, light)), n_h = std::max(0.0, glm::dot(p.normal, half));
  const glm::dvec3 bumped = p.bump.x * p.tangent + p.bump.y * p.binormal + p.bump.z * p.normal;
  const double gouraud = material.diffuse * n_l + material.specular * std::pow(n_h, material.shininess);
  return std::max(0.0, gouraud + material.diffuse * (std::max(0.0, glm::dot(bumped, light)) - n_l));
}

Point any_point(Random& random) {
  Point p = random.point(1.0);
  if (random.word() % 4 == 0) p.light = -p.light;
  if (random.word() % 4 == 0) p.binormal = -p.binormal;
  p.light *= random.uniform(0.2, 9);
  return p;
}

}  // namespace

TEST_CASE("the high end of Ernst 1998 is built of the operators of its column in Table 1 of Lee 2007") {
  const Design design = designed("ernst1998");
  CHECK(operators(design.environment) == Operators{27, 18, 9, 3, 0, 0});
  CHECK(operators(design.illumination) == Operators{7, 5, 0, 0, 1, 0});
  CHECK(operators(design.environment) == published_operators("environment"));
  CHECK(operators(design.illumination) == published_operators("illumination"));
  CHECK(design.interpolants.size() == 15);
}

TEST_CASE("the Gouraud engine of Ernst 1998 is four multipliers and four adders") {
  const Design design = designed("ernst1998", {{"variant", "gouraud"}});
  CHECK(operators(design.environment) == Operators{3, 3, 0, 0, 0, 0});
  CHECK(operators(design.illumination) == Operators{1, 1, 0, 0, 0, 0});
  CHECK(design.interpolants.size() == 4);
}

TEST_CASE("the map of Ernst 1998 is Peercy's with k = -1: (fu, fv, 1)") {
  const Design design = designed("ernst1998");
  REQUIRE(design.map.channels.size() == 2);
  Random random(47);
  for (int i = 0; i < 200; ++i) {
    const double fu = random.uniform(-3, 3), fv = random.uniform(-3, 3), k = -1;
    const glm::dvec3 peercy(-k * fu, -k * fv, k * k);  // Eqs 9-11 of Peercy 1997
    double channels[2];
    design.map.encode(glm::normalize(peercy), channels);
    CHECK(channels[0] == Approx(fu));
    CHECK(channels[1] == Approx(fv));
  }
}

TEST_CASE("the environment of Ernst 1998 is Eq 7 of Peercy 1997 and the direction of (fu, fv, 1)") {
  const Design design = designed("ernst1998", {{"word_bits", "16"}});
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Random random(53);
    std::vector<Point> points;
    std::vector<glm::dvec3> halves, slopes;
    Planes planes;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      points.push_back(random.point());
      const Point& p = points.back();
      halves.push_back(random.uniform(0.6, 1) * random.direction());  // as interpolation leaves it
      slopes.push_back({random.uniform(-6, 6), random.uniform(-6, 6), 1});
      set_vector(planes, "N", i, p.normal);
      set_vector(planes, "T", i, p.tangent);
      set_vector(planes, "B", i, p.binormal);
      set_vector(planes, "L", i, p.light);
      set_vector(planes, "H", i, halves.back());
      planes["map.u"][i] = slopes.back().x;
      planes["map.v"][i] = slopes.back().y;
    }
    run(design.environment, arithmetic, planes);
    const double tolerance = arithmetic == Arithmetic::real ? 1e-12 : 1e-3;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto in_tangent_space = [&](const glm::dvec3& v) {
        return glm::normalize(glm::dvec3(glm::dot(v, points[i].tangent), glm::dot(v, points[i].binormal), glm::dot(v, points[i].normal)));
      };
      CHECK(glm::length(vector_of(planes, "L_unit", i) - in_tangent_space(points[i].light)) < tolerance);
      CHECK(glm::length(vector_of(planes, "H_unit", i) - in_tangent_space(halves[i])) < tolerance);
      CHECK(glm::length(vector_of(planes, "N_unit", i) - glm::normalize(slopes[i])) < tolerance);
    }
  }
}

TEST_CASE("the steepest texels of Ernst 1998 do not overflow") {
  for (const char* integer_bits : {"0", "4"}) {
    const Design design = designed("ernst1998", {{"slope_integer_bits", integer_bits}});
    const double limit = design.map.channels.front().format.lowest();
    Random random(59);
    Planes planes;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      for (const char* name : {"N", "T", "B", "L", "H"}) set_vector(planes, name, i, random.direction());
      planes["map.u"][i] = i % 2 == 0 ? limit : -limit;
      planes["map.v"][i] = i % 4 < 2 ? limit : -limit;
    }
    run(design.environment, Arithmetic::fixed, planes);
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const glm::dvec3 expected = glm::normalize(glm::dvec3(planes["map.u"][i], planes["map.v"][i], 1));
      CHECK(glm::length(vector_of(planes, "N_unit", i) - expected) < 0.01);
    }
  }
}

TEST_CASE("the high end of Ernst 1998 in double precision is the illumination equation") {
  const Material material;
  CHECK(accuracy(designed("ernst1998"), material, 16, any_point).real_to_exact_db > 250);
}

TEST_CASE("the Gouraud engine of Ernst 1998 adds the bump's diffuse term to the vertex intensity") {
  const Material material{0.1, 0.6, 0.3, 12};
  const Design design = designed("ernst1998", {{"variant", "gouraud"}}, material);
  Random random(61);
  int darkened_to_nothing = 0;
  for (int block = 0; block < 4; ++block) {
    std::vector<Point> points;
    for (int i = 0; i < block_lanes; ++i) points.push_back(any_point(random));
    const Planes real = shade(design, Arithmetic::real, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double expected = gouraud_intensity(points[i], material);
      CHECK(real.at("intensity")[i] == Approx(expected).margin(1e-12));
      darkened_to_nothing += expected == 0 ? 1 : 0;
    }
  }
  CHECK(darkened_to_nothing > 10);
}

TEST_CASE("the Gouraud engine of Ernst 1998 is exact at vertices where the texel is flat") {
  const Material material;
  const auto flat = [](Random& r) {
    Point p = any_point(r);
    p.bump = {0, 0, 1};
    return p;
  };
  CHECK(accuracy(designed("ernst1998", {{"variant", "gouraud"}}), material, 4, flat).real_to_exact_db > 250);
}

TEST_CASE("fixed point keeps Ernst 1998 above 50 dB at its defaults") {
  const Material material;
  for (const char* variant : {"high_end", "gouraud"})
    CHECK(accuracy(designed("ernst1998", {{"variant", variant}}), material, 20, [](Random& r) { return r.point(); }).fixed_to_real_db > 50);
}

TEST_CASE("Ernst 1998 gains six decibels a bit") {
  const Material material;
  const auto db = [&](const char* bits) {
    const Design design = designed("ernst1998", {{"word_bits", bits}, {"slope_bits", "16"}, {"light_table_bits", "12"}}, material);
    return accuracy(design, material, 20, [](Random& r) { return r.point(); }).fixed_to_real_db;
  };
  CHECK(db("10") - db("8") == Approx(12).margin(3));
}
