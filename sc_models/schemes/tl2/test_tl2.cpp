#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

/// Longitude and latitude about y, turns.
Polar about_y(const glm::dvec3& v) {
  constexpr double two_pi = 6.283185307179586476925;
  return {std::atan2(v.x, v.z) / two_pi, std::atan2(v.y, std::hypot(v.x, v.z)) / two_pi};
}

void set_angles(Planes& planes, const std::string& name, std::size_t lane, const glm::dvec3& v) {
  const Polar angles = about_y(v);
  planes[name + ".psi"][lane] = angles.phi;
  planes[name + (name == "map" ? ".latitude" : ".b")][lane] = angles.theta;
}

/// The largest error of both dot products in double precision, random directions over the whole sphere.
double worst_error(const Design& design) {
  Random random(41);
  double worst = 0;
  for (int block = 0; block < 20; ++block) {
    Planes planes;
    std::vector<std::array<glm::dvec3, 3>> vectors;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      vectors.push_back({random.direction(), random.direction(), random.direction()});
      set_angles(planes, "L", i, vectors[i][0]);
      set_angles(planes, "H", i, vectors[i][1]);
      set_angles(planes, "map", i, vectors[i][2]);
    }
    run(design.environment, Arithmetic::real, planes, block_lanes);
    const auto evaluator = run(design.illumination, Arithmetic::real, planes, block_lanes);
    const int n_l = design.illumination.find("N_L.dot"), n_h = design.illumination.find("N_H.dot");
    for (int i = 0; i < block_lanes; ++i) {
      const auto& v = vectors[static_cast<std::size_t>(i)];
      worst = std::max(worst, std::abs(evaluator->value(n_l, i) - glm::dot(v[0], v[2])));
      worst = std::max(worst, std::abs(evaluator->value(n_h, i) - glm::dot(v[1], v[2])));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("TL2 takes two multipliers, ten adders and six tables for both dot products") {
  const Design design = designed("tl2");
  require_counts(design.environment, Portion::published, 0, 6, 0);
  // One more adder and two tables make the light of them.
  require_counts(design.illumination, Portion::published, 2, 4 + 1, 6 + 2);
  require_counts(design.environment, Portion::addition, 0, 0, 0);
  CHECK(columns_read(design.illumination) == 6 + 2);
}

TEST_CASE("TL2 interpolates four angles, or the six components that Peercy 1997 interpolates") {
  CHECK(designed("tl2").interpolants.size() == 4);
  CHECK(designed("tl2", {{"angles", "pixel"}}).interpolants.size() == 6);
}

TEST_CASE("angles of TL2 per pixel take neither multiplier nor divider nor root") {
  const Design design = designed("tl2", {{"angles", "pixel"}});
  REQUIRE(design.conversion);
  require_counts(*design.conversion, Portion::published, 0, 10, 10);
  CHECK(count(*design.conversion).index_encoders == 4);
}

TEST_CASE("TL2 is the dot product of vectors all over the sphere") {
  CHECK(worst_error(designed("tl2")) < 1e-12);
}

TEST_CASE("TL2 gives dot products that were worked out by hand") {
  // N' = (0, sin 30, cos 30), L = (sin 60, 0, cos 60), H = (0, 1/sqrt 2, 1/sqrt 2): N'.L = cos 30 cos 60, N'.H = cos 15.
  const Design design = designed("tl2");
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    for (const char* name : {"L.psi", "L.b", "H.psi", "H.b", "map.psi", "map.latitude"}) planes[name][0] = 0;
    planes["map.latitude"][0] = 30.0 / 360;
    planes["L.psi"][0] = 60.0 / 360;
    planes["H.b"][0] = 45.0 / 360;
    run(design.environment, arithmetic, planes, 1);
    const auto evaluator = run(design.illumination, arithmetic, planes, 1);
    const double margin = arithmetic == Arithmetic::real ? 1e-13 : 0.003;
    CHECK(evaluator->value(design.illumination.find("N_L.dot"), 0) == Approx(0.4330127018922193).margin(margin));
    CHECK(evaluator->value(design.illumination.find("N_H.dot"), 0) == Approx(0.9659258262890683).margin(margin));
  }
}

TEST_CASE("TL2 is the illumination equation anywhere, mirrored charts and unlit points included") {
  const Material material;
  for (const char* angles : {"vertex", "pixel"}) {
    CAPTURE(angles);
    const auto exact_db = [&](const std::function<Point(Random&)>& draw) {
      return accuracy(designed("tl2", {{"angles", angles}}, material), material, 4, draw).real_to_exact_db;
    };
    CHECK(exact_db(anywhere) > 200);
    CHECK(exact_db(mirrored_point) > 200);
    for (const double side : {1.0, -1.0}) CHECK(exact_db([side](Random& r) { return point_on_axis(r, side); }) > 200);
    CHECK(exact_db([](Random& r) {
            Point p = anywhere(r);
            p.light = -p.light;
            return p;
          }) > 200);
  }
}

TEST_CASE("a vector along the pole of TL2 has a latitude and any longitude") {
  const Material material;
  const auto along_binormal = [](Random& r) {
    Point p = anywhere(r);
    p.light = r.uniform(-1, 1) < 0 ? p.binormal : -p.binormal;
    return p;
  };
  for (const char* angles : {"vertex", "pixel"}) {
    const Accuracy found = accuracy(designed("tl2", {{"angles", angles}}, material), material, 4, along_binormal);
    CHECK(found.real_to_exact_db > 150);
    CHECK(found.fixed_to_real_db > 45);
  }
}

TEST_CASE("two-ported ROMs halve the tables of TL2 and change nothing else") {
  require_ports_change_nothing("tl2");
}

TEST_CASE("fixed point keeps TL2 near its formula, in highlights too") {
  const Material material;
  CHECK(accuracy(designed("tl2", {}, material), material, 30, anywhere).fixed_to_real_db > 48);
  const Design fine = designed("tl2", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, anywhere).fixed_to_real_db > 58);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 52);
  const Design pixel = designed("tl2", {{"angles", "pixel"}, {"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(pixel, material, 30, anywhere).fixed_to_real_db > 50);
}

TEST_CASE("the conversion of TL2 finds the angles of vectors of any length up to 1, as near as their components are fine") {
  const Design design = designed("tl2", {{"angles", "pixel"}, {"angle_bits", "14"}, {"inverse_table_bits", "12"}});
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Random random(7);
    double worst = 0;
    for (int block = 0; block < 8; ++block) {
      Planes planes;
      std::vector<glm::dvec3> vectors;
      for (std::size_t i = 0; i < block_lanes; ++i) {
        vectors.push_back(random.direction());
        const double length = random.uniform(0.4, 1);  // as interpolation leaves it
        for (const std::string name : {"L", "H"}) {
          planes[name + ".x"][i] = length * vectors[i].x;
          planes[name + ".y"][i] = length * vectors[i].y;
          planes[name + ".z"][i] = length * vectors[i].z;
        }
      }
      run(*design.conversion, arithmetic, planes, block_lanes);
      for (std::size_t i = 0; i < block_lanes; ++i)
        for (const std::string name : {"L", "H"})
          worst = std::max(worst, glm::length(from_y_pole(planes[name + ".psi"][i], planes[name + ".b"][i]) - vectors[i]));
    }
    // Components of 12 bits are steps of 2^-11, 2.5 times as coarse in the shortest vectors; logarithms and tables take as much again.
    CHECK(worst < (arithmetic == Arithmetic::real ? 1e-12 : 0.006));
    CHECK(worst > 0);
  }
}
