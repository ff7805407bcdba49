#include <catch2/catch.hpp>

#include "testbench/tests/schemes/polar_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("the corrected rotation of Lee 2007 takes two multipliers, ten adders and eleven tables a vector") {
  require_counts(designed("lee2007_corrected").environment, Portion::published, 4, 20, 22);
  const Design other =
      designed("lee2007_corrected", {{"angle_bits", "9"}, {"table_bits", "6"}, {"inverse_table_bits", "12"}, {"word_bits", "18"}});
  require_counts(other.environment, Portion::published, 4, 20, 22);
}

TEST_CASE("the corrected Lee 2007 reads thirty-six table columns a pixel beside the light tables") {
  int columns = 0;
  const Design design = designed("lee2007_corrected");
  for (const Netlist* unit : {&design.environment, &design.illumination})
    for (const Node& node : unit->nodes()) columns += node.op == Op::column ? 1 : 0;
  CHECK(columns == 36 + 2);
  CHECK(count(design.environment).index_encoders == 8);
}

TEST_CASE("the corrected rotation of Lee 2007 is built of its equations") {
  const Netlist environment = designed("lee2007_corrected").environment;
  Random random(3);
  Planes planes;
  std::vector<Polar> normal, light;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    normal.push_back(polar_of(random.direction()));
    light.push_back(polar_of(random.direction()));
    set_polar(planes, "N", i, normal.back());
    set_polar(planes, "L", i, light.back());
    set_polar(planes, "H", i, light.back());
  }
  const auto evaluator = run(environment, Arithmetic::real, planes);
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const auto node = [&](const char* name) { return evaluator->value(environment.find(std::string("L.") + name), static_cast<int>(i)); };
    const glm::dvec3 turned = rotated(from_polar(light[i].phi, light[i].theta), {normal[i].phi, 0});
    CHECK(node("G") == Approx(turned.x).margin(1e-14));
    CHECK(node("K") == Approx(turned.y).margin(1e-14));
    const glm::dvec3 of_z = rotated(turned, {0, normal[i].theta});
    CHECK(node("x_prime") == Approx(of_z.x).margin(1e-13));
    CHECK(node("z_prime") == Approx(of_z.z).margin(1e-13));
  }
}

TEST_CASE("the corrected rotation of Lee 2007 is lit as Lee 2007 is") {
  require_counts(designed("lee2007_corrected").illumination, Portion::published, 2, 11, 8);
  require_counts(designed("lee2007_corrected", {{"form", "13"}}).illumination, Portion::published, 2, 13, 8);
  require_counts(designed("lee2007_corrected").illumination, Portion::addition, 0, 1, 0);
  require_counts(designed("lee2007_corrected", {{"frame", "none"}}).illumination, Portion::addition, 0, 0, 0);
}

TEST_CASE("vector texels are converted beside the corrected rotation of Lee 2007") {
  const Design design = designed("lee2007_corrected", {{"map_filter", "vector"}});
  require_counts(design.environment, Portion::published, 4, 20, 22);
  require_counts(design.environment, Portion::addition, 2, 8, 2, 2, 1);
  CHECK(design.map.channels.size() == 3);
  CHECK(design.map.filterable);
}

TEST_CASE("the corrected rotation of Lee 2007 is a rotation") {
  const Design design = designed("lee2007_corrected");
  CHECK(worst_rotation_error(design.environment, Arithmetic::real) < 1e-10);
  require_golden_rotations(design.environment);
}

TEST_CASE("the corrected rotation of Lee 2007 with its illumination is the illumination equation in double precision") {
  for (const char* angles : {"vertex", "pixel"})
    for (const char* frame : {"face", "pixel"}) require_exact_illumination("lee2007_corrected", {{"angles", angles}, {"frame", frame}});
  require_exact_illumination("lee2007_corrected", {{"form", "13"}});
  // A texel within one unit of its last place of flat has no azimuth.
  const Material material;
  CHECK(accuracy(designed("lee2007_corrected", {{"map_filter", "vector"}}, material), material, 8, anywhere).real_to_exact_db > 90);
}

TEST_CASE("the corrected rotation of Lee 2007 shades a mirrored texture chart right with the mirror flag only") {
  const Material material;
  const auto db = [&](const char* mirror) {
    return accuracy(designed("lee2007_corrected", {{"mirror", mirror}}, material), material, 8, mirrored_point).real_to_exact_db;
  };
  CHECK(db("true") > 200);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps the corrected rotation of Lee 2007 near its formula") {
  const Material material;
  CHECK(accuracy(designed("lee2007_corrected", {}, material), material, 30, anywhere).fixed_to_real_db > 55);
  const Design vector = designed("lee2007_corrected", {{"map_filter", "vector"}, {"angles", "pixel"}}, material);
  CHECK(accuracy(vector, material, 30, anywhere).fixed_to_real_db > 54);
  CHECK(accuracy(designed("lee2007_corrected", {}, material), material, 30, point_in_highlight).fixed_to_real_db > 48);
  const Design fine = designed("lee2007_corrected", {{"inverse_table_bits", "12"}, {"word_bits", "14"}}, material);
  CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 53);
  require_six_decibels_a_bit("lee2007_corrected");
}
