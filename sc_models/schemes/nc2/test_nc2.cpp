#include <catch2/catch.hpp>
#include <cmath>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("NC2 takes two multipliers, and six adders a stage") {
  for (const int stages : {4, 9, 12, 18}) {
    CAPTURE(stages);
    const Design design = designed("nc2", {{"stages", std::to_string(stages).c_str()}});
    require_counts(design.environment, Portion::published, 0, 5 + (3 * stages - 1) + (3 * stages - 4), 3);
    require_counts(design.illumination, Portion::published, 2, 11, 8);
    CHECK(columns_read(design.environment) + columns_read(design.illumination) == 11 + 2);
    CHECK(count(design.environment).shifters == 0);
    CHECK(count(design.environment).index_encoders == 0);
  }
  require_counts(designed("nc2", {{"form", "13"}}).illumination, Portion::published, 2, 13, 8);
}

TEST_CASE("two-ported ROMs spare NC2 a sine and cosine table and change nothing else") {
  const Design one = designed("nc2"), two = designed("nc2", {{"ports", "2"}});
  CHECK(count(one.environment).table_bits - count(two.environment).table_bits == 1024 * 2 * 12);
  Random random(43);
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) points.push_back(point_on_parallel(random));
  const bool same = shade(one, Arithmetic::fixed, points).at("intensity") == shade(two, Arithmetic::fixed, points).at("intensity");
  CHECK(same);
}

TEST_CASE("NC2 gives dot products that were computed once by another program") {
  const Design design = designed("nc2");
  const double degree = 1.0 / 360;
  const auto at = [&](double phi, double theta) { return from_polar(phi * degree, theta * degree); };
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    set_inputs(planes, 0, {at(40, 30), at(60, 45), {70 * degree, 30 * degree}, 20 * degree, 10 * degree});
    set_inputs(planes, 1, {at(-100, 80), at(20, 25), {50 * degree, 60 * degree}, -15 * degree, 25 * degree});
    run(design.environment, arithmetic, planes, 2);
    const auto evaluator = run(design.illumination, arithmetic, planes, 2);
    const double margin = arithmetic == Arithmetic::real ? 0.001 : 0.004;
    const int n_l = design.illumination.find("N_L.dot"), n_h = design.illumination.find("N_H.dot");
    CHECK(evaluator->value(n_l, 0) == Approx(0.8314688804204511).margin(margin));
    CHECK(evaluator->value(n_h, 0) == Approx(0.9516341410628895).margin(margin));
    CHECK(evaluator->value(n_l, 1) == Approx(-0.6433815692294562).margin(margin));
    CHECK(evaluator->value(n_h, 1) == Approx(0.7260622825929289).margin(margin));
  }
}

TEST_CASE("NC2 is the dot product of the rotated vectors but for the angles that its stages leave") {
  for (const int stages : {6, 9, 12, 15, 18}) {
    CAPTURE(stages);
    const double left = std::atan(std::ldexp(1.0, 1 - stages));
    const double worst = worst_dot_error(designed("nc2", {{"stages", std::to_string(stages).c_str()}}));
    CHECK(worst < 2 * left);
    CHECK(worst > left / 4);
  }
}

TEST_CASE("NC2 is near the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  const Material material;
  const auto db = [&](Settings settings, Point (*draw)(Random&)) {
    return accuracy(designed("nc2", settings, material), material, 8, draw).real_to_exact_db;
  };
  CHECK(db({}, point_on_parallel) > 62);
  CHECK(db({{"stages", "16"}}, point_on_parallel) > 86);
  CHECK(db({{"frame", "meridian"}}, point_on_meridian) > 62);
  CHECK(db({{"frame", "pixel"}}, anywhere) > 62);
  CHECK(db({{"angles", "pixel"}}, point_on_parallel) > 62);
  CHECK(db({}, point_on_meridian) < 40);
}

TEST_CASE("NC2 shades a mirrored texture chart right with the mirror flag only") {
  const Material material;
  const auto db = [&](const char* mirror) {
    const auto draw = [](Random& r) {
      Point p = point_on_parallel(r);
      p.binormal = -p.binormal;
      return p;
    };
    return accuracy(designed("nc2", {{"mirror", mirror}}, material), material, 8, draw).real_to_exact_db;
  };
  CHECK(db("true") > 62);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps NC2 near its formula, at the object's poles too") {
  const Material material;
  CHECK(accuracy(designed("nc2", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("nc2", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 56);
  CHECK(accuracy(fine, material, 30, [](Random& r) { return point_on_axis(r, 1); }).fixed_to_real_db > 56);
}

TEST_CASE("NC2 gains six decibels a bit") {
  const Material material;
  const auto db = [&](Settings settings) {
    return accuracy(designed("nc2", settings, material), material, 20, point_on_parallel).fixed_to_exact_db;
  };
  const double ten = db({{"angle_bits", "10"},
                         {"word_bits", "10"},
                         {"table_bits", "8"},
                         {"stages", "12"},
                         {"light_table_bits", "12"},
                         {"texel_psi_bits", "9"},
                         {"texel_latitude_bits", "9"}}),
               twelve = db({{"angle_bits", "12"},
                            {"word_bits", "12"},
                            {"table_bits", "10"},
                            {"stages", "14"},
                            {"light_table_bits", "12"},
                            {"texel_psi_bits", "11"},
                            {"texel_latitude_bits", "11"}}),
               fourteen = db({{"angle_bits", "14"},
                              {"word_bits", "14"},
                              {"table_bits", "12"},
                              {"stages", "16"},
                              {"light_table_bits", "12"},
                              {"texel_psi_bits", "13"},
                              {"texel_latitude_bits", "13"}});
  CAPTURE(ten, twelve, fourteen);
  CHECK(ten > 46);
  CHECK(twelve - ten == Approx(12).margin(2.5));
  CHECK(fourteen - twelve == Approx(12).margin(2.5));
}
