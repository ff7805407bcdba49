#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("YP4 takes four multipliers and thirty-three adders for both dot products") {
  require_counts(designed("yp4").environment, Portion::published, 0, 31, 18);
  require_counts(designed("yp4").environment, Portion::addition, 0, 0, 0);
  // One more adder and two tables make the light of them.
  require_counts(designed("yp4").illumination, Portion::published, 4, 2 + 1, 0 + 2);
  const Design other = designed("yp4", {{"angle_bits", "9"}, {"table_bits", "7"}, {"word_bits", "9"}, {"angles", "pixel"}});
  require_counts(other.environment, Portion::published, 0, 31, 18);
}

TEST_CASE("YP4 reads 18 columns of tables") {
  const Design design = designed("yp4");
  CHECK(columns_read(design.environment) + columns_read(design.illumination) == 18 + 2);
  CHECK(count(design.environment).index_encoders == 0);
}

TEST_CASE("two-ported ROMs halve the tables of YP4") {
  require_ports_change_nothing("yp4");
}

TEST_CASE("a texel of YP4 is turned by alpha beside the design") {
  const Design design = designed("yp4", {{"frame", "pixel"}});
  require_counts(design.environment, Portion::published, 0, 31, 18);
  require_counts(design.environment, Portion::addition, 5, 6, 7);
}

TEST_CASE("YP4 is the dot product of the rotated vectors") {
  CHECK(worst_dot_error(designed("yp4")) < 1e-14);
  require_golden_dots(designed("yp4"));
}

TEST_CASE("YP4 is the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  require_exact_charts("yp4");
}

TEST_CASE("YP4 shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("yp4");
}

TEST_CASE("fixed point keeps YP4 near its formula") {
  const Material material;
  CHECK(accuracy(designed("yp4", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("yp4", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 60);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 55);
  const Design turned = designed("yp4", {{"frame", "pixel"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(turned, material, 30, anywhere).fixed_to_real_db > 45);
  require_six_decibels_of_sums("yp4");
}
