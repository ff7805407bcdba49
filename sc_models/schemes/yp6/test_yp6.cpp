#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("YP6 takes six multipliers and nineteen adders for both dot products") {
  require_counts(designed("yp6").environment, Portion::published, 0, 15, 9);
  require_counts(designed("yp6").environment, Portion::addition, 0, 0, 0);
  // One more adder and two tables make the light of them.
  require_counts(designed("yp6").illumination, Portion::published, 6, 4 + 1, 2);
  const Design other = designed("yp6", {{"angle_bits", "9"}, {"table_bits", "7"}, {"word_bits", "9"}, {"angles", "pixel"}});
  require_counts(other.environment, Portion::published, 0, 15, 9);
}

TEST_CASE("YP6 reads fifteen columns of sines and cosines") {
  const Design design = designed("yp6");
  CHECK(columns_read(design.environment) == 15);
  CHECK(count(design.environment).table_bits == 15 * 1024 * 12);
  CHECK(count(design.environment).index_encoders == 0);
}

TEST_CASE("two-ported ROMs halve the tables of YP6") {
  require_ports_change_nothing("yp6");
  CHECK(count(designed("yp6", {{"ports", "2"}}).environment).table_bits == 8 * 1024 * 12);
}

TEST_CASE("a texel of YP6 is turned by alpha beside the design") {
  const Design design = designed("yp6", {{"frame", "pixel"}});
  require_counts(design.environment, Portion::published, 0, 15, 9);
  require_counts(design.environment, Portion::addition, 5, 6, 7);
}

TEST_CASE("YP6 is the dot product of the rotated vectors") {
  CHECK(worst_dot_error(designed("yp6")) < 1e-14);
  require_golden_dots(designed("yp6"));
}

TEST_CASE("YP6 is the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  require_exact_charts("yp6");
}

TEST_CASE("YP6 shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("yp6");
}

TEST_CASE("fixed point keeps YP6 near its formula") {
  const Material material;
  CHECK(accuracy(designed("yp6", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("yp6", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 60);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 55);
  const Design turned = designed("yp6", {{"frame", "pixel"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(turned, material, 30, anywhere).fixed_to_real_db > 45);
  require_six_decibels_of_sums("yp6");
}
