#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("LNS takes nineteen adders and six shifters for both dot products, and no multiplier") {
  const Design design = designed("lns");
  require_counts(design.environment, Portion::published, 0, 9, 6);
  require_counts(design.environment, Portion::addition, 0, 0, 0);
  // One more adder and two tables make the light of them.
  require_counts(design.illumination, Portion::published, 0, 10 + 1, 6 + 2);
  CHECK(count(design.environment).shifters == 0);
  CHECK(count(design.illumination).shifters == 6);
  const Design other = designed("lns", {{"angle_bits", "9"}, {"table_bits", "7"}, {"log_bits", "8"}, {"angles", "pixel"}});
  require_counts(other.environment, Portion::published, 0, 9, 6);
  CHECK(count(other.illumination).shifters == 6);
}

TEST_CASE("LNS reads eighteen columns of logarithms and antilogarithms") {
  const Design design = designed("lns");
  CHECK(columns_read(design.environment) == 12);
  CHECK(columns_read(design.illumination) == 6 + 2);
  CHECK(count(design.environment).table_bits == 12 * 1024 * 16);
  CHECK(count(design.environment).index_encoders == 0);
}

TEST_CASE("two-ported ROMs halve the tables of LNS") {
  require_ports_change_nothing("lns");
  const auto bits = [](const char* ports) { return count(designed("lns", {{"ports", ports}}).illumination).table_bits; };
  CHECK(bits("1") - bits("2") == 3 * 1024 * 12);
}

TEST_CASE("LNS gives dot products that were computed once by another program") {
  const Design design = designed("lns");
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

TEST_CASE("LNS is the dot product of the rotated vectors") {
  CHECK(worst_dot_error(designed("lns")) < 1e-12);
}

TEST_CASE("LNS is the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  require_exact_charts("lns");
}

TEST_CASE("LNS shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("lns");
}

TEST_CASE("a factor of zero makes a product of zero in logarithms") {
  const Design design = designed("lns");
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    // Flat texels: sin b = 0 with sin theta_A sin d = 1; cos theta_A cos b cos Psi = 0 too, and d a quarter turn.
    set_inputs(planes, 0, {{0, 1, 0}, {0, -1, 0}, {0, 0}, 0, 0});
    run(design.environment, arithmetic, planes, 1);
    const auto evaluator = run(design.illumination, arithmetic, planes, 1);
    for (const char* dot : {"N_L.dot", "N_H.dot"}) CHECK(std::abs(evaluator->value(design.illumination.find(dot), 0)) < 0.002);
  }
}

TEST_CASE("fixed point keeps LNS near its formula") {
  const Material material;
  CHECK(accuracy(designed("lns", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("lns", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 58);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 52);
}

TEST_CASE("LNS gains six decibels a bit") {
  const Material material;
  const auto db = [&](Settings settings) {
    return accuracy(designed("lns", settings, material), material, 20, point_on_parallel).fixed_to_exact_db;
  };
  const double ten = db({{"angle_bits", "10"},
                         {"word_bits", "10"},
                         {"table_bits", "8"},
                         {"log_bits", "10"},
                         {"antilog_table_bits", "9"},
                         {"light_table_bits", "12"},
                         {"texel_psi_bits", "9"},
                         {"texel_latitude_bits", "9"}}),
               twelve = db({{"angle_bits", "12"},
                            {"word_bits", "12"},
                            {"table_bits", "10"},
                            {"log_bits", "12"},
                            {"antilog_table_bits", "11"},
                            {"light_table_bits", "12"},
                            {"texel_psi_bits", "11"},
                            {"texel_latitude_bits", "11"}}),
               fourteen = db({{"angle_bits", "14"},
                              {"word_bits", "14"},
                              {"table_bits", "12"},
                              {"log_bits", "14"},
                              {"antilog_table_bits", "13"},
                              {"light_table_bits", "12"},
                              {"texel_psi_bits", "13"},
                              {"texel_latitude_bits", "13"}});
  CAPTURE(ten, twelve, fourteen);
  CHECK(ten > 46);
  CHECK(twelve - ten == Approx(12).margin(2.5));
  CHECK(fourteen - twelve == Approx(12).margin(2.5));
}

TEST_CASE("shorter logarithms and light words make LNS smaller, leave its formula and keep a picture of 8 bits") {
  const Material material;
  const Design full = designed("lns", {}, material), small = designed("lns", {{"log_whole_bits", "3"}, {"light_word_bits", "9"}}, material);
  // A bit less of the two columns of six reads; 7 bits less of two light tables.
  CHECK(count(full.environment).table_bits - count(small.environment).table_bits == 12 * 1024);
  CHECK(count(full.illumination).table_bits - count(small.illumination).table_bits == 2 * 7 * 1024);
  CHECK(worst_dot_error(small) < 1e-12);
  const Accuracy found = accuracy(small, material, 30, point_on_parallel);
  CHECK(found.real_to_exact_db > 200);
  CHECK(found.fixed_to_real_db > 46);
  CHECK(small.quantisation_floor_db < full.quantisation_floor_db);
  CHECK(accuracy(designed("lns", {{"log_whole_bits", "2"}}, material), material, 20, point_on_parallel).fixed_to_real_db >
        small.quantisation_floor_db);
}
