#include <algorithm>
#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("LNSG takes thirty adders, one that adds alpha, ten shifters and no multiplier") {
  const Design design = designed("lnsg");
  require_counts(design.environment, Portion::published, 0, 12, 7);
  require_counts(design.environment, Portion::addition, 0, 1, 0);
  require_counts(design.illumination, Portion::published, 0, 18 + 1, 10 + 2);
  CHECK(count(design.environment).shifters == 0);
  CHECK(count(design.illumination).shifters == 10);
  CHECK(columns_read(design.environment) == 14);
  require_counts(designed("lnsg", {{"frame", "none"}}).environment, Portion::addition, 0, 0, 0);
}

TEST_CASE("two-ported ROMs halve the tables of LNSG and change nothing else") {
  const Design one = designed("lnsg"), two = designed("lnsg", {{"ports", "2"}});
  CHECK(count(one.environment).table_bits == 7 * 2 * 1024 * 16);
  CHECK(count(two.environment).table_bits == 4 * 2 * 1024 * 16);
  Random random(43);
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) points.push_back(random.point());
  const bool same = shade(one, Arithmetic::fixed, points).at("intensity") == shade(two, Arithmetic::fixed, points).at("intensity");
  CHECK(same);
}

TEST_CASE("LNSG is the dot product of the rotated vectors, whatever the angle of the tangent") {
  const Design design = designed("lnsg");
  Random random(47);
  double worst = 0;
  for (int block = 0; block < 20; ++block) {
    Planes planes;
    std::vector<glm::dvec3> light, half;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto turn = [&] { return random.uniform(-0.5, 0.5); };
      const Polar normal{turn(), turn()}, texel{turn(), random.uniform(0, 0.5)};
      const glm::dvec3 l = random.direction(), h = random.direction();
      const double alpha = turn();
      set_polar(planes, "N", i, normal);
      set_polar(planes, "L", i, polar_of(l));
      set_polar(planes, "H", i, polar_of(h));
      set_polar(planes, "map", i, texel);
      planes["alpha"][i] = alpha;
      const glm::dvec3 bumped = from_polar(texel.phi + alpha, texel.theta);
      planes["expected_l"][i] = glm::dot(bumped, rotated(l, normal));
      planes["expected_h"][i] = glm::dot(bumped, rotated(h, normal));
    }
    run(design.environment, Arithmetic::real, planes);
    const auto evaluator = run(design.illumination, Arithmetic::real, planes);
    const int n_l = design.illumination.find("N_L.dot"), n_h = design.illumination.find("N_H.dot");
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      worst = std::max(worst, std::abs(evaluator->value(n_l, lane) - planes["expected_l"][i]));
      worst = std::max(worst, std::abs(evaluator->value(n_h, lane) - planes["expected_h"][i]));
    }
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("LNSG gives dot products that were computed once by another program") {
  const Design design = designed("lnsg");
  const double degree = 1.0 / 360;
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    set_polar(planes, "N", 0, {70 * degree, 30 * degree});
    set_polar(planes, "L", 0, {40 * degree, 30 * degree});
    set_polar(planes, "H", 0, {60 * degree, 45 * degree});
    set_polar(planes, "map", 0, {-40 * degree, 25 * degree});
    planes["alpha"][0] = 15 * degree;
    run(design.environment, arithmetic, planes, 1);
    const auto evaluator = run(design.illumination, arithmetic, planes, 1);
    const double margin = arithmetic == Arithmetic::real ? 1e-13 : 0.008;
    CHECK(evaluator->value(design.illumination.find("N_L.dot"), 0) == Approx(0.8983836269145928).margin(margin));
    CHECK(evaluator->value(design.illumination.find("N_H.dot"), 0) == Approx(0.9880588062364527).margin(margin));
  }
}

TEST_CASE("LNSG is the illumination equation wherever the tangent points") {
  for (const char* angles : {"vertex", "pixel"})
    for (const char* frame : {"face", "pixel"}) require_exact_illumination("lnsg", {{"angles", angles}, {"frame", frame}});
}

TEST_CASE("LNSG shades a mirrored texture chart right with the mirror flag only") {
  const Material material;
  const auto db = [&](const char* mirror) {
    return accuracy(designed("lnsg", {{"mirror", mirror}}, material), material, 8, mirrored_point).real_to_exact_db;
  };
  CHECK(db("true") > 200);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps LNSG near its formula") {
  const Material material;
  CHECK(accuracy(designed("lnsg", {}, material), material, 30, anywhere).fixed_to_real_db > 50);
  const Design fine = designed("lnsg", {{"texel_phi_bits", "12"}, {"texel_theta_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, anywhere).fixed_to_real_db > 56);
}

TEST_CASE("LNSG gains six decibels a bit") {
  const Material material;
  const auto db = [&](Settings settings) {
    return accuracy(designed("lnsg", settings, material), material, 20, anywhere).fixed_to_exact_db;
  };
  const double eight = db({{"angle_bits", "8"},
                           {"word_bits", "8"},
                           {"table_bits", "6"},
                           {"log_bits", "8"},
                           {"antilog_table_bits", "7"},
                           {"light_table_bits", "12"},
                           {"texel_phi_bits", "8"},
                           {"texel_theta_bits", "6"}}),
               ten = db({{"angle_bits", "10"},
                         {"word_bits", "10"},
                         {"table_bits", "8"},
                         {"log_bits", "10"},
                         {"antilog_table_bits", "9"},
                         {"light_table_bits", "12"},
                         {"texel_phi_bits", "10"},
                         {"texel_theta_bits", "8"}}),
               twelve = db({{"angle_bits", "12"},
                            {"word_bits", "12"},
                            {"table_bits", "10"},
                            {"log_bits", "12"},
                            {"antilog_table_bits", "11"},
                            {"light_table_bits", "12"},
                            {"texel_phi_bits", "12"},
                            {"texel_theta_bits", "10"}});
  CAPTURE(eight, ten, twelve);
  CHECK(eight > 40);
  CHECK(ten - eight == Approx(12).margin(2.5));
  CHECK(twelve - ten == Approx(12).margin(2.5));
}
