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

TEST_CASE("TL0 takes ten adders, nine tables and two shifters for both dot products, and no multiplier") {
  const Design design = designed("tl0");
  require_counts(design.environment, Portion::published, 0, 4, 3);
  // One more adder and two tables make the light of them.
  require_counts(design.illumination, Portion::published, 0, 6 + 1, 6 + 2);
  require_counts(design.environment, Portion::addition, 0, 0, 0);
  CHECK(count(design.illumination).shifters == 2);
  CHECK(columns_read(design.environment) + columns_read(design.illumination) == 9 + 2);
}

TEST_CASE("a factor of zero makes a share of no more than the least cosine's in TL0") {
  // N' on the pole: cos b = 0, and the dot product is sin b_A whatever the longitudes.
  const Design design = designed("tl0");
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    Random random(3);
    for (std::size_t i = 0; i < block_lanes; ++i) {
      planes["map.latitude"][i] = 0.25;
      for (const char* name : {"map.psi", "L.psi", "H.psi"}) planes[name][i] = random.uniform(-0.5, 0.5);
      for (const char* name : {"L.b", "H.b"}) planes[name][i] = random.uniform(-0.25, 0.25);
    }
    // The logarithm of a cosine ends below 8, so that twice 2^-8 is left; angles and words take the rest.
    const double margin = arithmetic == Arithmetic::real ? 1e-12 : std::ldexp(1.0, -7) + 0.0025;
    const Planes given = planes;
    run(design.environment, arithmetic, planes, block_lanes);
    const auto evaluator = run(design.illumination, arithmetic, planes, block_lanes);
    for (int i = 0; i < block_lanes; ++i) {
      const double sine = std::sin(6.283185307179586 * given.at("L.b")[static_cast<std::size_t>(i)]);
      CHECK(evaluator->value(design.illumination.find("N_L.dot"), i) == Approx(sine).margin(margin));
    }
  }
}

TEST_CASE("TL0 interpolates four angles, or the six components that Peercy 1997 interpolates") {
  CHECK(designed("tl0").interpolants.size() == 4);
  CHECK(designed("tl0", {{"angles", "pixel"}}).interpolants.size() == 6);
}

TEST_CASE("angles of TL0 per pixel take neither multiplier nor divider nor root") {
  const Design design = designed("tl0", {{"angles", "pixel"}});
  REQUIRE(design.conversion);
  require_counts(*design.conversion, Portion::published, 0, 10, 10);
  CHECK(count(*design.conversion).index_encoders == 4);
}

TEST_CASE("TL0 is the dot product of vectors all over the sphere") {
  CHECK(worst_error(designed("tl0")) < 1e-12);
}

TEST_CASE("TL0 gives dot products that were worked out by hand") {
  // N' = (0, sin 30, cos 30), L = (sin 60, 0, cos 60), H = (0, 1/sqrt 2, 1/sqrt 2): N'.L = cos 30 cos 60, N'.H = cos 15.
  const Design design = designed("tl0");
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

TEST_CASE("TL0 is the illumination equation anywhere, mirrored charts and unlit points included") {
  const Material material;
  for (const char* angles : {"vertex", "pixel"}) {
    CAPTURE(angles);
    const auto exact_db = [&](const std::function<Point(Random&)>& draw) {
      return accuracy(designed("tl0", {{"angles", angles}}, material), material, 4, draw).real_to_exact_db;
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

TEST_CASE("a vector along the pole of TL0 has a latitude and any longitude") {
  const Material material;
  const auto along_binormal = [](Random& r) {
    Point p = anywhere(r);
    p.light = r.uniform(-1, 1) < 0 ? p.binormal : -p.binormal;
    return p;
  };
  for (const char* angles : {"vertex", "pixel"}) {
    const Accuracy found = accuracy(designed("tl0", {{"angles", angles}}, material), material, 4, along_binormal);
    CHECK(found.real_to_exact_db > 150);
    CHECK(found.fixed_to_real_db > 45);
  }
}

TEST_CASE("two-ported ROMs halve the tables of TL0 and change nothing else") {
  require_ports_change_nothing("tl0");
}

TEST_CASE("fixed point keeps TL0 near its formula, in highlights too") {
  const Material material;
  CHECK(accuracy(designed("tl0", {}, material), material, 30, anywhere).fixed_to_real_db > 48);
  const Design fine = designed("tl0", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, anywhere).fixed_to_real_db > 58);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 52);
  const Design pixel = designed("tl0", {{"angles", "pixel"}, {"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(pixel, material, 30, anywhere).fixed_to_real_db > 50);
}
