#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/error.h"
#include "testbench/tests/schemes/polar_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

constexpr double two_pi = 6.283185307179586476925;

/// A point on the object's equator whose map is wrapped around the z axis.
Point point_on_equator(Random& r) {
  Point p = r.point();
  const double phi = r.uniform(0, two_pi);
  p.normal = {std::cos(phi), std::sin(phi), 0};
  p.tangent = {-std::sin(phi), std::cos(phi), 0};
  p.binormal = {0, 0, 1};
  return p;
}

}  // namespace

TEST_CASE("Kim 2001 is built of the operators that Table 1 of Lee 2007 charges it") {
  require_counts(designed("kim2001").environment, Portion::published, 31, 18, 6);
  require_counts(designed("kim2001").illumination, Portion::published, 6, 5, 12);
  require_counts(designed("kim2001").illumination, Portion::addition, 0, 0, 0);
}

TEST_CASE("what Table 1 leaves out of Kim 2001 is counted apart") {
  // Two azimuths by a divider, a table and three adders each.
  require_counts(designed("kim2001").environment, Portion::addition, 0, 6, 2, 2);
  const Design vector = designed("kim2001", {{"map_filter", "vector"}});
  require_counts(vector.environment, Portion::published, 31, 18, 6);
  require_counts(vector.environment, Portion::addition, 2, 14, 4, 4, 1);
}

TEST_CASE("Kim 2001 needs fewer tables when they are counted as those of Lee 2007 are") {
  require_counts(designed("kim2001", {{"tables", "dual"}}).illumination, Portion::published, 6, 5, 8);
  require_counts(designed("kim2001", {{"tables", "shared"}}).illumination, Portion::published, 6, 5, 7);
}

TEST_CASE("Kim 2001 without a transform perturbs by two adders") {
  const Design design = designed("kim2001", {{"transform", "direct"}});
  require_counts(design.environment, Portion::published, 0, 2, 0);
  require_counts(design.environment, Portion::addition, 0, 0, 0);
  require_counts(design.illumination, Portion::published, 6, 5, 12);
  CHECK(design.interpolants.size() == 6);
  CHECK(!design.conversion);
}

TEST_CASE("however its tables are counted, Kim 2001 computes the same words") {
  Random random(5);
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) points.push_back(random.point());
  const auto intensity = [&](const char* tables) {
    return shade(designed("kim2001", {{"tables", tables}}), Arithmetic::fixed, points)["intensity"];
  };
  CHECK(intensity("separate") == intensity("dual"));
  CHECK(intensity("separate") == intensity("shared"));
}

TEST_CASE("the reconstructed transform of Kim 2001 is the transform by T, B, N") {
  const Netlist environment = designed("kim2001").environment;
  Random random(7);
  Planes planes;
  std::vector<Point> points;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    points.push_back(random.point());
    const Point& p = points.back();
    for (const auto& [name, v] : {std::pair<std::string, glm::dvec3>{"N", p.normal}, {"T", p.tangent}, {"B", p.binormal}})
      for (int axis = 0; axis < 3; ++axis) planes[name + "." + "xyz"[axis]][i] = v[axis];
    set_polar(planes, "L", i, polar_of(p.light));
    set_polar(planes, "H", i, polar_of(p.view));
    set_polar(planes, "map", i, polar_of(p.bump));
  }
  run(environment, Arithmetic::real, planes);
  double worst = 0;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const Point& p = points[i];
    const auto expected = [&](const glm::dvec3& v) {
      return glm::dvec3(glm::dot(v, p.tangent), glm::dot(v, p.binormal), glm::dot(v, p.normal));
    };
    const auto found = [&](const std::string& name) { return from_polar(planes[name + ".phi"][i], planes[name + ".theta"][i]); };
    worst = std::max(worst, glm::length(found("L_ref") - expected(p.light)));
    worst = std::max(worst, glm::length(found("H_ref") - expected(p.view)));
    worst = std::max(worst, glm::length(found("N_L") - p.bump));
    const glm::dvec3 third(planes["N_ref.x"][i], planes["N_ref.y"][i], planes["N_ref.z"][i]);
    worst = std::max(worst, glm::length(third - glm::dvec3(0, 0, 1)));
  }
  CHECK(worst < 1e-10);
}

TEST_CASE("the illumination of Kim 2001 is two dot products") {
  const Material material{0, 1, 0, 1};  // intensity = N'.L where lit
  for (const char* tables : {"separate", "dual", "shared"}) {
    Random random(3);
    Planes planes;
    std::vector<double> expected;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const glm::dvec3 light = random.direction(), normal = random.direction();
      set_polar(planes, "L_ref", i, polar_of(light));
      set_polar(planes, "H_ref", i, polar_of(random.direction()));
      for (const char* name : {"N_L", "N_H"}) set_polar(planes, name, i, polar_of(normal));
      expected.push_back(std::max(0.0, glm::dot(light, normal)));
    }
    run(designed("kim2001", {{"tables", tables}}, material).illumination, Arithmetic::real, planes);
    for (std::size_t i = 0; i < expected.size(); ++i) CHECK(planes["intensity"][i] == Approx(expected[i]).margin(1e-13));
  }
}

TEST_CASE("Kim 2001 with the transform is the illumination equation in double precision") {
  for (const char* angles : {"vertex", "pixel"}) require_exact_illumination("kim2001", {{"angles", angles}});
  const Material material;
  // The matrix is whatever the frame is: mirrored charts need nothing.
  CHECK(accuracy(designed("kim2001", {}, material), material, 8, mirrored_point).real_to_exact_db > 200);
  CHECK(accuracy(designed("kim2001", {{"map_filter", "vector"}}, material), material, 8, anywhere).real_to_exact_db > 90);
}

TEST_CASE("Kim 2001 without a transform is right on the object's equator only") {
  const Material material;
  const Design design = designed("kim2001", {{"transform", "direct"}}, material);
  CHECK(accuracy(design, material, 8, point_on_equator).real_to_exact_db > 200);
  const auto wrapped_at = [](double theta) {
    return [theta](Random& r) {
      Point p = point_on_equator(r);
      const double phi = std::atan2(p.normal.y, p.normal.x);
      p.normal = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      p.binormal = glm::cross(p.normal, p.tangent);
      return p;
    };
  };
  const double sixty = accuracy(design, material, 8, wrapped_at(1.05)).real_to_exact_db,
               twenty = accuracy(design, material, 8, wrapped_at(0.35)).real_to_exact_db;
  CHECK(sixty > 25);
  CHECK(twenty < sixty - 3);
  CHECK(accuracy(design, material, 8, anywhere).real_to_exact_db < 20);
}

TEST_CASE("the tangent of a map for Kim 2001 without a transform may run along theta") {
  const Material material;
  const auto south = [](Random& r) {
    Point p = point_on_equator(r);
    p.binormal = p.tangent;  // growing phi
    p.tangent = {0, 0, -1};  // growing theta
    return p;
  };
  CHECK(accuracy(designed("kim2001", {{"transform", "direct"}, {"tangent", "theta"}}, material), material, 8, south).real_to_exact_db >
        200);
  CHECK(accuracy(designed("kim2001", {{"transform", "direct"}}, material), material, 8, south).real_to_exact_db < 30);
}

TEST_CASE("changes of angle are not filtered as vectors") {
  try {
    designed("kim2001", {{"transform", "direct"}, {"map_filter", "vector"}});
    FAIL("contradictory settings were taken");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::input);
  }
}

TEST_CASE("fixed point keeps Kim 2001 near its formula") {
  const Material material;
  CHECK(accuracy(designed("kim2001", {}, material), material, 30, anywhere).fixed_to_real_db > 55);
  CHECK(accuracy(designed("kim2001", {{"map_filter", "vector"}}, material), material, 30, anywhere).fixed_to_real_db > 54);
  CHECK(accuracy(designed("kim2001", {{"transform", "direct"}}, material), material, 30, anywhere).fixed_to_real_db > 51);
  CHECK(accuracy(designed("kim2001", {}, material), material, 30, point_in_highlight).fixed_to_real_db > 47);
  require_six_decibels_a_bit("kim2001");
}
