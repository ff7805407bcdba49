#include <algorithm>
#include <catch2/catch.hpp>

#include "testbench/tests/schemes/vector_bench.h"
#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

TEST_CASE("CART takes fourteen multipliers and eight adders for both dot products") {
  require_counts(designed("cart").environment, Portion::all, 8, 4, 2);
  require_counts(designed("cart").illumination, Portion::all, 6, 4 + 1, 2);
  CHECK(columns_read(designed("cart").environment) == 4);
}

TEST_CASE("CART with an interpolated matrix takes a multiplier and two adders more, and no sine") {
  const Design design = designed("cart", {{"normal", "matrix"}});
  require_counts(design.environment, Portion::all, 9, 6, 0);
  require_counts(design.illumination, Portion::all, 6, 4 + 1, 2);
}

TEST_CASE("CART with texels of angles takes four multipliers less for three adders and three columns more") {
  const Design design = designed("cart", {{"texel", "angles"}});
  require_counts(design.environment, Portion::all, 4, 7, 4);
  require_counts(design.illumination, Portion::all, 6, 4 + 1, 2);
  CHECK(columns_read(design.environment) == 7);
}

TEST_CASE("CART does not turn texels of angles by a matrix") {
  CHECK_THROWS_WITH(designed("cart", {{"texel", "angles"}, {"normal", "matrix"}}), Catch::Contains("contradicts"));
}

TEST_CASE("two-ported ROMs halve the tables of CART") {
  require_ports_change_nothing("cart");
}

TEST_CASE("CART is the dot product with the rotated normal") {
  Random random(7);
  double worst = 0;
  for (int block = 0; block < 20; ++block) {
    const Design design = designed("cart", {{"texel", block % 2 == 0 ? "vector" : "angles"}});
    Planes planes;
    std::vector<YPoleInputs> inputs;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto turn = [&] { return random.uniform(-0.5, 0.5); };
      inputs.push_back({random.direction(), random.direction(), {turn(), turn()}, turn(), turn()});
      set_inputs(planes, i, inputs.back());
      set_vector(planes, "L", i, inputs.back().light);
      set_vector(planes, "H", i, inputs.back().half);
      const glm::dvec3 bumped = from_y_pole(inputs.back().psi, inputs.back().latitude);
      planes["map.x"][i] = bumped.x;
      planes["map.y"][i] = bumped.y;
      planes["map.minus_z"][i] = -bumped.z;
    }
    run(design.environment, Arithmetic::real, planes);
    const auto illumination = run(design.illumination, Arithmetic::real, planes);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto dot = [&](const char* node) { return illumination->value(design.illumination.find(node), static_cast<int>(i)); };
      worst = std::max(worst, std::abs(dot("N_L.dot") - inputs[i].dot(inputs[i].light)));
      worst = std::max(worst, std::abs(dot("N_H.dot") - inputs[i].dot(inputs[i].half)));
    }
  }
  CHECK(worst < 1e-14);
}

TEST_CASE("CART is the illumination equation on charts that its map is made for, and anywhere with a matrix") {
  const Material material;
  const auto db = [&](Settings settings, const std::function<Point(Random&)>& draw) {
    return accuracy(designed("cart", settings, material), material, 4, draw).real_to_exact_db;
  };
  for (const char* texel : {"vector", "angles"}) {
    CHECK(db({{"texel", texel}}, point_on_parallel) > 200);
    CHECK(db({{"texel", texel}, {"frame", "meridian"}}, point_on_meridian) > 200);
  }
  CHECK(db({{"normal", "matrix"}}, anywhere) > 200);
  CHECK(db({{"normal", "matrix"}}, mirrored_point) > 200);
  for (const double side : {1.0, -1.0})
    for (const char* frame : {"parallel", "meridian"})
      CHECK(db({{"frame", frame}}, [side](Random& r) { return point_on_axis(r, side); }) > 200);
  CHECK(db({}, point_on_meridian) < 40);
  CHECK(db({{"frame", "meridian"}}, point_on_parallel) < 40);
  CHECK(db({}, [](Random& r) {
          Point p = point_on_parallel(r);
          p.binormal = -p.binormal;
          return p;
        }) < 40);
}

TEST_CASE("fixed point keeps CART near its formula") {
  const Material material;
  for (const char* normal : {"angles", "matrix"}) {
    CAPTURE(normal);
    CHECK(accuracy(designed("cart", {{"normal", normal}}, material), material, 30, point_on_parallel).fixed_to_real_db > 49);
    const Design fine = designed("cart", {{"normal", normal}, {"texel_bits", "12"}}, material);
    CHECK(accuracy(fine, material, 30, point_on_parallel).fixed_to_real_db > 60);
    CHECK(accuracy(fine, material, 30, point_in_highlight).fixed_to_real_db > 55);
  }
  CHECK(
      accuracy(designed("cart", {{"texel", "angles"}, {"texel_bits", "12"}}, material), material, 30, point_on_parallel).fixed_to_real_db >
      60);
  require_six_decibels_of_sums("cart");
}
