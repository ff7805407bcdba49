#include <catch2/catch.hpp>

#include "testbench/tests/schemes/vector_bench.h"
#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("EXACT10 takes ten multipliers, twenty-seven adders and eleven tables, light included") {
  require_counts(designed("exact10").environment, Portion::all, 4, 22, 9);
  require_counts(designed("exact10").illumination, Portion::all, 6, 5, 2);
  const Design other = designed("exact10", {{"angle_bits", "9"}, {"table_bits", "7"}, {"word_bits", "9"}, {"frame", "meridian"}});
  require_counts(other.environment, Portion::all, 4, 22, 9);
  require_counts(other.illumination, Portion::all, 6, 5, 2);
}

TEST_CASE("EXACT10 reads eighteen columns of sines and cosines") {
  CHECK(columns_read(designed("exact10").environment) == 18);
  require_ports_change_nothing("exact10");
}

TEST_CASE("a texel of EXACT10 is turned by alpha beside the design") {
  const Design design = designed("exact10", {{"frame", "pixel"}});
  require_counts(design.environment, Portion::all, 4, 22, 9);
  require_counts(design.illumination, Portion::published, 6, 5, 2);
  require_counts(design.illumination, Portion::addition, 4, 2, 1);
}

TEST_CASE("EXACT10 is a rotation") {
  Random random(5);
  double worst = 0;
  for (int block = 0; block < 20; ++block)
    for (const char* frame : {"parallel", "meridian"}) {
      Planes planes;
      std::vector<YPoleInputs> inputs;
      for (std::size_t i = 0; i < block_lanes; ++i) {
        inputs.push_back({random.direction(), random.direction(), {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, 0, 0});
        set_inputs(planes, i, inputs.back());
      }
      run(designed("exact10", {{"frame", frame}}).environment, Arithmetic::real, planes);
      // T = e_phi and B = -e_theta on parallels.
      const bool parallel = std::string(frame) == "parallel";
      const auto along_frame = [&](const glm::dvec3& v) { return parallel ? glm::dvec3(v.y, -v.x, v.z) : v; };
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        worst = std::max(worst, glm::length(vector_of(planes, "L_ref", i) - along_frame(rotated(inputs[i].light, inputs[i].normal))));
        worst = std::max(worst, glm::length(vector_of(planes, "H_ref", i) - along_frame(rotated(inputs[i].half, inputs[i].normal))));
      }
    }
  CHECK(worst < 1e-14);
  const Netlist along_angles = designed("exact10", {{"frame", "meridian"}}).environment;
  Planes planes;
  for (std::size_t i = 0; i < golden_rotations().size(); ++i) {
    const GoldenRotation& golden = golden_rotations()[i];
    for (const char* name : {"L", "H"}) set_polar(planes, name, i, {golden.a.phi / 360, golden.a.theta / 360});
    set_polar(planes, "N", i, {golden.normal.phi / 360, golden.normal.theta / 360});
  }
  run(along_angles, Arithmetic::real, planes, static_cast<int>(golden_rotations().size()));
  for (std::size_t i = 0; i < golden_rotations().size(); ++i) {
    const Polar expected = golden_rotations()[i].expected;
    CHECK(glm::length(vector_of(planes, "L_ref", i) - from_polar(expected.phi / 360, expected.theta / 360)) < 2e-4);
  }
}

TEST_CASE("EXACT10 is the illumination equation on charts of either kind, and anywhere with a turned texel") {
  require_exact_charts("exact10");
}

TEST_CASE("EXACT10 shades a mirrored texture chart right with the mirror flag only") {
  require_mirrored_charts("exact10");
}

TEST_CASE("fixed point keeps EXACT10 near its formula") {
  const Material material;
  CHECK(accuracy(designed("exact10", {}, material), material, 30, point_on_parallel).fixed_to_real_db > 49);
  const Design fine = designed("exact10", {{"texel_bits", "12"}}, material);
  CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 60);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 55);
  const Design turned = designed("exact10", {{"frame", "pixel"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(turned, material, 30, anywhere).fixed_to_real_db > 48);
  require_six_decibels_of_sums("exact10");
}
