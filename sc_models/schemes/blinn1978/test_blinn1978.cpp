#include <catch2/catch.hpp>
#include <cmath>

#include "schemes/common/slope_map.h"
#include "testbench/tests/schemes/vector_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

/// Vectors as interpolation may leave them: shortened, and Pu, Pv neither equal nor orthogonal to one another or to N.
struct Patch {
  glm::dvec3 normal, pu, pv, light, half;
  double bu, bv;
};

Patch random_patch(Random& random) {
  const Point p = random.point();
  const auto shortened = [&](const glm::dvec3& v) { return random.uniform(0.6, 1) * v; };
  Patch patch;
  patch.normal = shortened(p.normal);
  patch.pu = shortened(glm::normalize(p.tangent + 0.2 * random.direction()));
  patch.pv = shortened(glm::normalize(p.binormal + 0.2 * random.direction()));
  patch.light = shortened(p.light);
  patch.half = shortened(random.direction());
  patch.bu = random.uniform(-2, 2);
  patch.bv = random.uniform(-2, 2);
  return patch;
}

/// Eq 1 of Lee 2007, with the cross products as they stand.
glm::dvec3 perturbed(const Patch& p) {
  return glm::normalize(p.normal + p.bu * glm::cross(p.normal, p.pv) - p.bv * glm::cross(p.normal, p.pu));
}

}  // namespace

TEST_CASE("Blinn 1978 is 18 multipliers and 12 adders, or 12 and 9, before the normalisers") {
  CHECK(operators(designed("blinn1978").environment) == Operators{18 + 9, 12 + 6, 9, 3, 0, 0});
  CHECK(operators(designed("blinn1978", {{"perturbation", "factored"}}).environment) == Operators{12 + 9, 9 + 6, 9, 3, 0, 0});
  for (const char* perturbation : {"plain", "factored"})
    CHECK(operators(designed("blinn1978", {{"perturbation", perturbation}}).illumination) == Operators{7, 5, 0, 0, 1, 0});
}

TEST_CASE("Blinn 1978 interpolates five vectors and reads two slopes") {
  CHECK(designed("blinn1978").interpolants.size() == 15);
  CHECK(designed("blinn1978").map.channels.size() == 2);
}

TEST_CASE("turning Pu and Pv about at mirrored vertices is an addition of two cross products") {
  CHECK(operators(designed("blinn1978").vertex, Portion::addition) == Operators{12, 6, 0, 0, 0, 0});
}

TEST_CASE("the environment of Blinn 1978 is Eq 1 of Lee 2007 for any Pu and Pv") {
  for (const char* perturbation : {"plain", "factored"}) {
    const Design design = designed("blinn1978", {{"perturbation", perturbation}, {"word_bits", "16"}});
    for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
      CAPTURE(perturbation, arithmetic == Arithmetic::real);
      Random random(41);
      std::vector<Patch> patches;
      Planes planes;
      for (std::size_t i = 0; i < block_lanes; ++i) {
        patches.push_back(random_patch(random));
        set_vector(planes, "N", i, patches[i].normal);
        set_vector(planes, "Pu", i, patches[i].pu);
        set_vector(planes, "Pv", i, patches[i].pv);
        set_vector(planes, "L", i, patches[i].light);
        set_vector(planes, "H", i, patches[i].half);
        planes["map.u"][i] = patches[i].bu;
        planes["map.v"][i] = patches[i].bv;
      }
      run(design.environment, arithmetic, planes);
      const double tolerance = arithmetic == Arithmetic::real ? 1e-12 : 1e-3;
      for (std::size_t i = 0; i < block_lanes; ++i) {
        CHECK(glm::length(vector_of(planes, "N_unit", i) - perturbed(patches[i])) < tolerance);
        CHECK(glm::length(vector_of(planes, "L_unit", i) - glm::normalize(patches[i].light)) < tolerance);
        CHECK(glm::length(vector_of(planes, "H_unit", i) - glm::normalize(patches[i].half)) < tolerance);
      }
    }
  }
}

TEST_CASE("the steepest slopes of Blinn 1978 do not overflow") {
  for (const char* perturbation : {"plain", "factored"})
    for (const char* integer_bits : {"0", "4"}) {
      const Design design = designed("blinn1978", {{"perturbation", perturbation}, {"slope_integer_bits", integer_bits}});
      const double limit = design.map.channels.front().format.lowest();
      Planes planes;
      for (std::size_t i = 0; i < 4; ++i) {
        set_vector(planes, "N", i, {0, 0, 1});
        set_vector(planes, "Pu", i, {1, 0, 0});
        set_vector(planes, "Pv", i, {0, 1, 0});
        set_vector(planes, "L", i, {0, 0, 1});
        set_vector(planes, "H", i, {0, 0, 1});
        planes["map.u"][i] = i % 2 == 0 ? limit : -limit;
        planes["map.v"][i] = i < 2 ? limit : -limit;
      }
      run(design.environment, Arithmetic::fixed, planes, 4);
      for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 expected = glm::normalize(glm::dvec3(-planes["map.u"][i], -planes["map.v"][i], 1));
        CHECK(glm::length(vector_of(planes, "N_unit", i) - expected) < 0.01);
      }
    }
}

TEST_CASE("Blinn 1978 in double precision is the illumination equation, also on mirrored charts") {
  const Material material;
  for (const char* perturbation : {"plain", "factored"}) {
    const Design design = designed("blinn1978", {{"perturbation", perturbation}}, material);
    CHECK(accuracy(design, material, 8, [](Random& r) { return r.point(1.2); }).real_to_exact_db > 250);
    const auto unlit_and_mirrored = [](Random& r) {
      Point p = r.point();
      p.light *= -7;
      p.view *= 0.2;
      p.binormal = -p.binormal;
      return p;
    };
    CHECK(accuracy(design, material, 8, unlit_and_mirrored).real_to_exact_db > 250);
    const auto mirrored = [](Random& r) {
      Point p = r.point();
      p.binormal = -p.binormal;
      return p;
    };
    CHECK(accuracy(design, material, 8, mirrored).real_to_exact_db > 250);
  }
}

TEST_CASE("slopes give the normal back, and steep ones keep their direction") {
  Random random(43);
  const double limit = 7.5;
  int kept = 0, held = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 normal = random.direction();
    const glm::dvec2 slopes = slopes_of(normal, limit);
    CHECK(std::max(std::abs(slopes.x), std::abs(slopes.y)) <= limit * (1 + 1e-12));
    CHECK(slopes.x * normal.y == Approx(slopes.y * normal.x).margin(1e-12));
    CHECK(slopes.x * normal.x >= 0);
    if (normal.z * limit > std::max(std::abs(normal.x), std::abs(normal.y))) {
      CHECK(glm::length(glm::normalize(glm::dvec3(slopes, 1)) - normal) < 1e-12);
      ++kept;
    } else {
      CHECK(std::max(std::abs(slopes.x), std::abs(slopes.y)) == Approx(limit));
      ++held;
    }
  }
  CHECK(kept > 500);
  CHECK(held > 500);
  CHECK(slopes_of({0, 0, -1}, limit) == glm::dvec2(0, 0));
}

TEST_CASE("fixed point keeps Blinn 1978 above 55 dB at its defaults, and gains six decibels a bit") {
  const Material material;
  for (const char* perturbation : {"plain", "factored"}) {
    const Design design = designed("blinn1978", {{"perturbation", perturbation}}, material);
    CHECK(accuracy(design, material, 20, [](Random& r) { return r.point(); }).fixed_to_real_db > 55);
    const auto db = [&](const char* bits) {
      const Design other = designed(
          "blinn1978", {{"perturbation", perturbation}, {"word_bits", bits}, {"slope_bits", "16"}, {"light_table_bits", "12"}}, material);
      return accuracy(other, material, 20, [](Random& r) { return r.point(); }).fixed_to_real_db;
    };
    CHECK(db("10") - db("8") == Approx(12).margin(3));
  }
}
