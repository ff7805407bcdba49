#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("N2L takes two multipliers for both dot products") {
  const Design design = designed("n2l");
  require_counts(design.environment, Portion::published, 0, 8, 6);
  require_counts(design.environment, Portion::addition, 0, 0, 0);
  require_counts(design.illumination, Portion::published, 2, 11, 8);
  require_counts(designed("n2l", {{"form", "13"}}).illumination, Portion::published, 2, 13, 8);
  CHECK(columns_read(design.environment) + columns_read(design.illumination) == 12 + 2);
  CHECK(count(design.environment).index_encoders == 2);
  CHECK(count(design.environment).shifters == 0);
}

TEST_CASE("two-ported ROMs spare N2L a cosine table and change nothing else") {
  const Design one = designed("n2l"), two = designed("n2l", {{"ports", "2"}});
  CHECK(count(one.environment).table_bits - count(two.environment).table_bits == 1024 * 18);
  Random random(43);
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) points.push_back(point_on_parallel(random));
  const bool same = shade(one, Arithmetic::fixed, points).at("intensity") == shade(two, Arithmetic::fixed, points).at("intensity");
  CHECK(same);
}

TEST_CASE("N2L gives dot products that were computed once by another program") {
  const Design design = designed("n2l");
  const double degree = 1.0 / 360;
  const auto at = [&](double phi, double theta) { return from_polar(phi * degree, theta * degree); };
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    set_inputs(planes, 0, {at(40, 30), at(60, 45), {70 * degree, 30 * degree}, 20 * degree, 10 * degree});
    set_inputs(planes, 1, {at(-100, 80), at(20, 25), {50 * degree, 60 * degree}, -15 * degree, 25 * degree});
    run(design.environment, arithmetic, planes, 2);
    const auto evaluator = run(design.illumination, arithmetic, planes, 2);
    const double margin = arithmetic == Arithmetic::real ? 1e-13 : 0.004;
    const int n_l = design.illumination.find("N_L.dot"), n_h = design.illumination.find("N_H.dot");
    CHECK(evaluator->value(n_l, 0) == Approx(0.8314688804204511).margin(margin));
    CHECK(evaluator->value(n_h, 0) == Approx(0.9516341410628895).margin(margin));
    CHECK(evaluator->value(n_l, 1) == Approx(-0.6433815692294562).margin(margin));
    CHECK(evaluator->value(n_h, 1) == Approx(0.7260622825929289).margin(margin));
  }
}

TEST_CASE("N2L is the dot product of the rotated vectors") {
  CHECK(worst_dot_error(designed("n2l")) < 1e-12);
}

TEST_CASE("N2L is the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  require_exact_charts("n2l");
}

TEST_CASE("N2L shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("n2l");
}

TEST_CASE("fixed point keeps N2L near its formula, at the object's poles too") {
  const Material material;
  CHECK(accuracy(designed("n2l", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("n2l", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 50);
  CHECK(accuracy(fine, material, 30, [](Random& r) { return point_on_axis(r, 1); }).fixed_to_real_db > 50);
}

TEST_CASE("N2L gains six decibels a bit") {
  const Material material;
  const auto db = [&](Settings settings) {
    return accuracy(designed("n2l", settings, material), material, 20, point_on_parallel).fixed_to_exact_db;
  };
  const double ten = db({{"angle_bits", "10"},
                         {"word_bits", "10"},
                         {"table_bits", "8"},
                         {"inverse_table_bits", "10"},
                         {"log_bits", "10"},
                         {"light_table_bits", "12"},
                         {"texel_psi_bits", "9"},
                         {"texel_latitude_bits", "9"}}),
               twelve = db({{"angle_bits", "12"},
                            {"word_bits", "12"},
                            {"table_bits", "10"},
                            {"inverse_table_bits", "12"},
                            {"log_bits", "12"},
                            {"light_table_bits", "12"},
                            {"texel_psi_bits", "11"},
                            {"texel_latitude_bits", "11"}}),
               fourteen = db({{"angle_bits", "14"},
                              {"word_bits", "14"},
                              {"table_bits", "12"},
                              {"inverse_table_bits", "14"},
                              {"log_bits", "14"},
                              {"light_table_bits", "12"},
                              {"texel_psi_bits", "13"},
                              {"texel_latitude_bits", "13"}});
  CAPTURE(ten, twelve, fourteen);
  CHECK(ten > 46);
  CHECK(twelve - ten == Approx(12).margin(2.5));
  CHECK(fourteen - twelve == Approx(12).margin(2.5));
}
