#include <algorithm>
#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("YP6G takes six multipliers and thirty-four adders for both dot products, one of them for alpha") {
  require_counts(designed("yp6g").environment, Portion::published, 0, 29, 14);
  require_counts(designed("yp6g").environment, Portion::addition, 0, 1, 0);
  require_counts(designed("yp6g", {{"frame", "none"}}).environment, Portion::addition, 0, 0, 0);
  require_counts(designed("yp6g").illumination, Portion::published, 6, 4 + 1, 2);
}

TEST_CASE("YP6G reads twenty-four columns of sines and cosines") {
  CHECK(columns_read(designed("yp6g").environment) == 24);
  require_ports_change_nothing("yp6g");
}

TEST_CASE("vector texels are converted beside YP6G") {
  const Design design = designed("yp6g", {{"map_filter", "vector"}});
  require_counts(design.environment, Portion::published, 0, 29, 14);
  require_counts(design.environment, Portion::addition, 2, 9, 2, 2, 1);
}

TEST_CASE("YP6G is the dot product of the rotated vectors") {
  Random random(47);
  const Design design = designed("yp6g");
  double worst = 0;
  for (int block = 0; block < 20; ++block) {
    Planes planes;
    std::vector<double> light, half;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto turn = [&] { return random.uniform(-0.5, 0.5); };
      const glm::dvec3 l = random.direction(), h = random.direction();
      const Polar normal{turn(), turn()}, texel{turn(), turn()};
      const double alpha = turn();
      set_polar(planes, "L", i, polar_of(l));
      set_polar(planes, "H", i, polar_of(h));
      set_polar(planes, "N", i, normal);
      set_polar(planes, "map", i, texel);
      planes["alpha"][i] = alpha;
      const glm::dvec3 bumped = from_polar(texel.phi + alpha, texel.theta);
      light.push_back(glm::dot(bumped, rotated(l, normal)));
      half.push_back(glm::dot(bumped, rotated(h, normal)));
    }
    run(design.environment, Arithmetic::real, planes);
    const auto illumination = run(design.illumination, Arithmetic::real, planes);
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto dot = [&](const char* node) { return illumination->value(design.illumination.find(node), static_cast<int>(i)); };
      worst = std::max({worst, std::abs(dot("N_L.dot") - light[i]), std::abs(dot("N_H.dot") - half[i])});
    }
  }
  CHECK(worst < 1e-14);
}

TEST_CASE("YP6G is the illumination equation in double precision, whatever the tangents") {
  for (const char* angles : {"vertex", "pixel"})
    for (const char* frame : {"face", "pixel"}) require_exact_illumination("yp6g", {{"angles", angles}, {"frame", frame}});
  // A texel within one unit of its last place of flat has no azimuth.
  const Material material;
  CHECK(accuracy(designed("yp6g", {{"map_filter", "vector"}}, material), material, 8, anywhere).real_to_exact_db > 90);
}

TEST_CASE("YP6G shades a mirrored texture chart right with the mirror flag only") {
  const Material material;
  const auto db = [&](const char* mirror) {
    return accuracy(designed("yp6g", {{"mirror", mirror}}, material), material, 8, mirrored_point).real_to_exact_db;
  };
  CHECK(db("true") > 200);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps YP6G near its formula") {
  const Material material;
  CHECK(accuracy(designed("yp6g", {}, material), material, 30, anywhere).fixed_to_real_db > 55);
  const Design vector = designed("yp6g", {{"map_filter", "vector"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(vector, material, 30, anywhere).fixed_to_real_db > 54);
  CHECK(accuracy(designed("yp6g", {}, material), material, 30, point_in_highlight).fixed_to_real_db > 52);
  require_six_decibels_a_bit("yp6g");
}
