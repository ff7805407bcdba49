#include <catch2/catch.hpp>

#include "testbench/tests/schemes/polar_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("the exact polar rotation takes seven multipliers, three adders and six tables a vector, one of them shared") {
  // 2 x (7, 3, 6) less the sine and cosine of theta_N, which both vectors read.
  require_counts(designed("exact_polar").environment, Portion::published, 14, 6, 11);
  const Design other =
      designed("exact_polar", {{"angle_bits", "9"}, {"table_bits", "6"}, {"inverse_table_bits", "12"}, {"word_bits", "18"}});
  require_counts(other.environment, Portion::published, 14, 6, 11);
}

TEST_CASE("at the widths of Lee 2007 the exact polar rotation has its table storage within four percent") {
  const Design design =
      designed("exact_polar", {{"angle_bits", "10"}, {"table_bits", "8"}, {"inverse_table_bits", "8"}, {"word_bits", "16"}});
  // Bits: 5 x 2 columns of sines and cosines, 2 arc tangents, 2 arc cosines of 16 bits, 2 reciprocals of 20 bits.
  CHECK(count(design.environment).table_bits == 256 * (14 * 16 + 2 * 20));
}

TEST_CASE("the exact polar rotation is lit as Lee 2007 is") {
  require_counts(designed("exact_polar").illumination, Portion::published, 2, 11, 8);
  require_counts(designed("exact_polar", {{"form", "13"}}).illumination, Portion::published, 2, 13, 8);
  require_counts(designed("exact_polar").illumination, Portion::addition, 0, 1, 0);
  require_counts(designed("exact_polar", {{"frame", "none"}}).illumination, Portion::addition, 0, 0, 0);
}

TEST_CASE("vector texels are converted beside the exact polar rotation") {
  const Design design = designed("exact_polar", {{"map_filter", "vector"}});
  require_counts(design.environment, Portion::published, 14, 6, 11);
  require_counts(design.environment, Portion::addition, 2, 8, 2, 2, 1);
  CHECK(design.map.channels.size() == 3);
  CHECK(design.map.filterable);
}

TEST_CASE("the exact polar rotation is a rotation") {
  const Design design = designed("exact_polar");
  CHECK(worst_rotation_error(design.environment, Arithmetic::real) < 1e-10);
  require_golden_rotations(design.environment);
}

TEST_CASE("the exact polar rotation with its illumination is the illumination equation in double precision") {
  for (const char* angles : {"vertex", "pixel"})
    for (const char* frame : {"face", "pixel"}) require_exact_illumination("exact_polar", {{"angles", angles}, {"frame", frame}});
  require_exact_illumination("exact_polar", {{"form", "13"}});
  // A texel within one unit of its last place of flat has no azimuth.
  const Material material;
  CHECK(accuracy(designed("exact_polar", {{"map_filter", "vector"}}, material), material, 8, anywhere).real_to_exact_db > 90);
}

TEST_CASE("the exact polar rotation shades a mirrored texture chart right with the mirror flag only") {
  const Material material;
  const auto db = [&](const char* mirror) {
    return accuracy(designed("exact_polar", {{"mirror", mirror}}, material), material, 8, mirrored_point).real_to_exact_db;
  };
  CHECK(db("true") > 200);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps the exact polar rotation near its formula") {
  const Material material;
  CHECK(accuracy(designed("exact_polar", {}, material), material, 30, anywhere).fixed_to_real_db > 55);
  const Design vector = designed("exact_polar", {{"map_filter", "vector"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(vector, material, 30, anywhere).fixed_to_real_db > 54);
  CHECK(accuracy(designed("exact_polar", {}, material), material, 30, point_in_highlight).fixed_to_real_db > 48);
  const Design fine = designed("exact_polar", {{"inverse_table_bits", "12"}, {"word_bits", "14"}}, material);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 53);
  require_six_decibels_a_bit("exact_polar");
}
