#include <catch2/catch.hpp>

#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("YP0 takes seventy-three adders and no multiplier for both dot products") {
  require_counts(designed("yp0").environment, Portion::published, 0, 73, 32);
  require_counts(designed("yp0").environment, Portion::addition, 0, 0, 0);
  // One more adder and two tables make the light of them.
  require_counts(designed("yp0").illumination, Portion::published, 0, 0 + 1, 0 + 2);
  const Design other = designed("yp0", {{"angle_bits", "9"}, {"table_bits", "7"}, {"word_bits", "9"}, {"angles", "pixel"}});
  require_counts(other.environment, Portion::published, 0, 73, 32);
}

TEST_CASE("YP0 reads 32 columns of tables") {
  const Design design = designed("yp0");
  CHECK(columns_read(design.environment) + columns_read(design.illumination) == 32 + 2);
  CHECK(count(design.environment).index_encoders == 0);
}

TEST_CASE("two-ported ROMs halve the tables of YP0") {
  require_ports_change_nothing("yp0");
}

TEST_CASE("a texel of YP0 is turned by alpha beside the design") {
  const Design design = designed("yp0", {{"frame", "pixel"}});
  require_counts(design.environment, Portion::published, 0, 73, 32);
  require_counts(design.environment, Portion::addition, 5, 6, 7);
}

TEST_CASE("YP0 is the dot product of the rotated vectors") {
  CHECK(worst_dot_error(designed("yp0")) < 1e-14);
  require_golden_dots(designed("yp0"));
}

TEST_CASE("YP0 is the illumination equation on charts that its map is made for, and anywhere with a turned texel") {
  require_exact_charts("yp0");
}

TEST_CASE("YP0 shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("yp0");
}

TEST_CASE("fixed point keeps YP0 near its formula") {
  const Material material;
  CHECK(accuracy(designed("yp0", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 48);
  const Design fine = designed("yp0", {{"texel_psi_bits", "12"}, {"texel_latitude_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 60);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 55);
  const Design turned = designed("yp0", {{"frame", "pixel"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(turned, material, 30, anywhere).fixed_to_real_db > 45);
  require_six_decibels_of_sums("yp0");
}
