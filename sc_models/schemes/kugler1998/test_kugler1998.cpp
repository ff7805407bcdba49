#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "schemes/kugler1998/tables.h"
#include "testbench/tests/schemes/polar_bench.h"
#include "testbench/tests/schemes/vector_bench.h"
#include "units/colour_unit.h"

using namespace bump;
using namespace bump::bench;

namespace {

constexpr double two_pi = 6.283185307179586476925;

/// b about N, in Cartesian form: the frame (e_theta, e_phi, N) turned by psi to the tangent.
glm::dvec3 bumped_normal(const glm::dvec3& normal, double psi, double phi, double tilt) {
  const Polar n = polar_of(normal);
  const glm::dvec3 e_theta = from_polar(n.phi, n.theta + 0.25), e_phi = from_polar(n.phi + 0.25, 0.25), up = from_polar(n.phi, n.theta);
  const double azimuth = two_pi * (psi + phi);
  return std::sin(tilt) * (std::cos(azimuth) * e_theta + std::sin(azimuth) * e_phi) + std::cos(tilt) * up;
}

double tilt_of(double code, double max_tilt, int bits) {
  return code / (1 - std::ldexp(1.0, -bits)) * max_tilt / 360 * two_pi;
}

/// The largest distance of N' from the formula for random normals of random length, psi and bumps; normals beside the axis by at least
/// `off_axis`.
double worst_bump(const Netlist& environment, Arithmetic arithmetic, double max_tilt, int tilt_bits, double off_axis) {
  Random random(51);
  const auto reader = make_evaluator(environment, arithmetic);  // ROM contents live as long as one
  double worst = 0;
  for (int block = 0; block < 40; ++block) {
    Planes planes;
    std::vector<glm::dvec3> normals;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      glm::dvec3 normal = random.direction();
      while (std::max(std::abs(normal.x), std::abs(normal.y)) < off_axis) normal = random.direction();
      normals.push_back(normal);
      set_vector(planes, "N", i, normal * random.uniform(0.8, 0.999));
      planes["psi"][i] = random.uniform(-0.5, 0.5);
      planes["map.phi"][i] = std::floor(random.uniform(-128, 128)) / 256;
      planes["map.theta"][i] = std::floor(random.uniform(0, std::ldexp(1.0, tilt_bits))) * std::ldexp(1.0, -tilt_bits);
    }
    run(environment, arithmetic, planes);
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const glm::dvec3 expected =
          bumped_normal(normals[i], planes.at("psi")[i], planes.at("map.phi")[i], tilt_of(planes.at("map.theta")[i], max_tilt, tilt_bits));
      worst = std::max(worst, glm::length(expected - from_polar(planes.at("bumped.phi")[i], planes.at("bumped.theta")[i])));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("Kugler 1998's environment is built of the operators that Table 1 of Lee 2007 lists, and of second ports") {
  const Design design = designed("kugler1998");
  CHECK(operators(design.environment) == Operators{5, 2, 0, 0, 3, 1});
  CHECK(operators(design.environment, Portion::addition) == Operators{});
  CHECK(count(design.environment).second_ports == 2);
  CHECK_FALSE(design.conversion.has_value());
}

TEST_CASE("the map of bumps is the 32 Kbytes that Lee 2007 states") {
  const Design design = designed("kugler1998");
  for (const TablePtr& table : design.environment.tables())
    if (table->is_map()) {
      CHECK(table->entries() == 1 << 14);
      CHECK(table->bits() == 32 * 1024 * 8);
    }
}

TEST_CASE("address, light maps, sum and colour unit of Kugler 1998 are the illumination cell of Table 1 of Lee 2007") {
  const Design design = designed("kugler1998");
  REQUIRE(design.light_maps.has_value());
  const LightMaps& maps = *design.light_maps;
  CHECK(operators(maps.address) == Operators{4, 2, 0, 0, 5, 0});
  CHECK(operators(design.illumination) == Operators{1, 1, 0, 0, 0, 0});
  Scene scene;
  scene.lights.resize(3);
  scene.objects.resize(1);
  const Netlist colour = colour_netlist(scene, Material{}, ColourUnitConfig{}, LightSum::in_light_maps);
  CHECK(operators(colour) == Operators{3, 1, 0, 0, 0, 0});
  Inventory cell = count(maps.address);
  cell += count(design.illumination);
  cell += count(colour);
  CHECK(cell.multipliers == 8);
  CHECK(cell.adders == 4);
  CHECK(cell.tables == 5);
  CHECK(maps.maps.size() == 2);
  for (const LightMaps::Map& map : maps.maps) CHECK((std::int64_t{map.word.width} << maps.address_bits) == std::int64_t{8} << 20);
}

TEST_CASE("the counts of Kugler 1998 do not follow the widths") {
  const Design other = designed(
      "kugler1998", {{"angle_bits", "9"}, {"table_bits", "8"}, {"word_bits", "17"}, {"map_phi_bits", "4"}, {"light_map_bits", "13"}});
  CHECK(operators(other.environment) == Operators{5, 2, 0, 0, 3, 1});
  CHECK(operators(other.light_maps->address) == Operators{4, 2, 0, 0, 5, 0});
}

TEST_CASE("choices that Table 1 has no room for are counted apart") {
  const Design change = designed("kugler1998", {{"map_holds", "change"}});
  CHECK(operators(change.environment) == Operators{5, 2, 0, 0, 3, 1});
  CHECK(operators(change.environment, Portion::addition) == Operators{0, 1, 0, 0, 0, 0});
  CHECK(operators(designed("kugler1998", {{"frame", "none"}}).environment) == Operators{5, 1, 0, 0, 3, 1});
  const Design pixel = designed("kugler1998", {{"frame", "pixel"}});
  CHECK(operators(pixel.environment) == Operators{5, 2, 0, 0, 3, 1});
  REQUIRE(pixel.conversion.has_value());
  CHECK(operators(*pixel.conversion) == Operators{});
  CHECK(operators(*pixel.conversion, Portion::addition) == Operators{10, 9, 1, 1, 1, 0});
}

TEST_CASE("in double precision two adders and a map are the rotation of the bump by the normal, on the whole sphere") {
  CHECK(worst_bump(designed("kugler1998").environment, Arithmetic::real, 60, 4, 0.001) < 1e-9);
  CHECK(worst_bump(designed("kugler1998", {{"map_holds", "change"}}).environment, Arithmetic::real, 60, 4, 0.001) < 1e-9);
  CHECK(worst_bump(designed("kugler1998", {{"max_tilt", "20"}, {"map_tilt_bits", "5"}}).environment, Arithmetic::real, 20, 5, 0.001) <
        1e-9);
}

TEST_CASE("golden bumps: Rz(phi_N) Ry(theta_N) b by matrices, computed once by a program of its own, and the words of the hardware") {
  struct Golden {
    glm::dvec3 normal;
    double psi, phi;  // degrees
    int tilt;         // fifteenths of 60 degrees
    double expected_phi, expected_theta;
    int phi_word, theta_word;
  };
  const std::vector<Golden> golden{{{0.3, -0.4, -0.5}, 30, 40, 8, -6.5668, 136.7038, -61, 1568},
                                   {{0.9, 0.1, 0.2}, -75, 200, 15, 68.0947, 53.6387, 768, 600},
                                   {{-0.05, 0.08, 0.95}, 10, -120, 4, 32.2661, 15.0117, 380, 168},
                                   {{-0.6, 0.6, -0.1}, 130, 90, 11, 105.1051, 63.6221, 1181, 728}};
  const Netlist environment = designed("kugler1998").environment;
  Planes real;
  for (std::size_t i = 0; i < golden.size(); ++i) {
    set_vector(real, "N", i, golden[i].normal);
    real["psi"][i] = golden[i].psi / 360;
    real["map.phi"][i] = golden[i].phi / 360;
    real["map.theta"][i] = golden[i].tilt / 16.0;
  }
  Planes fixed = real;
  run(environment, Arithmetic::real, real, static_cast<int>(golden.size()));
  run(environment, Arithmetic::fixed, fixed, static_cast<int>(golden.size()));
  for (std::size_t i = 0; i < golden.size(); ++i) {
    CAPTURE(i);
    CHECK(real.at("bumped.phi")[i] * 360 == Approx(golden[i].expected_phi).margin(1e-4));
    CHECK(real.at("bumped.theta")[i] * 360 == Approx(golden[i].expected_theta).margin(1e-4));
    CHECK(fixed.at("bumped.phi")[i] * 4096 == golden[i].phi_word);
    CHECK(fixed.at("bumped.theta")[i] * 4096 == golden[i].theta_word);
  }
}

TEST_CASE("in fixed point N' is within what the steps of the map allow") {
  // theta_N by half a code (1.45 degrees), phi_1 by half a cell (2.8 degrees) times the sine of the tilt, words of 0.7 degrees, tables.
  const double codes = two_pi / 4 / 31 / 2 + std::sin(two_pi / 6) * two_pi / 128, words = two_pi / 512, tables = 0.03;
  CHECK(worst_bump(designed("kugler1998").environment, Arithmetic::fixed, 60, 4, 0.01) < codes + words + tables);
  const Settings fine{{"map_phi_bits", "6"}, {"map_theta_bits", "7"}, {"map_word_bits", "12"}, {"table_bits", "13"}};
  CHECK(worst_bump(designed("kugler1998", fine).environment, Arithmetic::fixed, 60, 4, 0.01) < 0.04);
}

TEST_CASE("axis-parallel and flat facets come through with less than half a degree") {
  const Netlist environment = designed("kugler1998").environment;
  const std::vector<glm::dvec3> axes{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Planes planes;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      set_vector(planes, "N", i, axes[i]);
      for (const char* flat : {"psi", "map.phi", "map.theta"}) planes[flat][i] = 0;
    }
    run(environment, arithmetic, planes, static_cast<int>(axes.size()));
    for (std::size_t i = 0; i < axes.size(); ++i) {
      CAPTURE(i);
      CHECK(degrees_between(axes[i], from_polar(planes.at("bumped.phi")[i], planes.at("bumped.theta")[i])) <
            (arithmetic == Arithmetic::real ? 1e-9 : 0.5));
    }
  }
}

TEST_CASE("the address of a direction means that direction") {
  for (const char* bits : {"11", "20", "21"}) {
    const Design design =
        designed("kugler1998", {{"light_map_bits", bits}, {"angle_bits", "16"}, {"table_bits", "13"}, {"word_bits", "16"}});
    const LightMaps& maps = *design.light_maps;
    const int rows = (maps.address_bits - 1) / 2, columns = maps.address_bits - 1 - rows;
    // Half a step of both coordinates, twice that on the sphere; and the words.
    const double cell = 2 * std::hypot(std::ldexp(1.0, -rows), std::ldexp(1.0, -columns)) + 2e-3;
    Random random(52);
    Planes real, fixed;
    std::vector<glm::dvec3> directions;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      directions.push_back(random.direction());
      set_polar(real, "bumped", i, polar_of(directions.back()));
    }
    fixed = real;
    real["light_map.base"].fill(0);
    const std::int64_t base = std::int64_t{5} << maps.address_bits;
    fixed["light_map.base"].fill(static_cast<double>(base));
    run(maps.address, Arithmetic::real, real);
    run(maps.address, Arithmetic::fixed, fixed);
    for (std::size_t i = 0; i < block_lanes; ++i) {
      double coordinates[3] = {real.at("light_map.s")[i], real.at("light_map.t")[i], real.at("light_map.below")[i]};
      REQUIRE(glm::length(maps.direction(coordinates) - directions[i]) < 1e-9);
      const auto entry = static_cast<std::int64_t>(fixed.at("light_map.entry")[i]) - base;
      REQUIRE(entry >= 0);
      REQUIRE(entry < std::int64_t{1} << maps.address_bits);
      maps.centre(entry, coordinates);
      REQUIRE(glm::length(maps.direction(coordinates) - directions[i]) < cell);
    }
  }
}

TEST_CASE("light maps are filled with the illumination equation") {
  const Material material{0.1, 0.6, 0.4, 30};
  const Design design = designed("kugler1998", {}, material);
  Random random(53);
  Planes planes;
  std::vector<std::array<glm::dvec3, 3>> vectors;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    vectors.push_back({random.direction(), random.direction(), random.direction()});
    set_vector(planes, "N", i, vectors[i][0]);
    set_vector(planes, "L", i, vectors[i][1]);
    set_vector(planes, "H", i, vectors[i][2]);
  }
  run(design.light_maps->fill, Arithmetic::real, planes);
  for (std::size_t i = 0; i < block_lanes; ++i) {
    CHECK(planes.at("diffuse")[i] == Approx(0.6 * std::max(0.0, glm::dot(vectors[i][0], vectors[i][1]))).margin(1e-12));
    CHECK(planes.at("specular")[i] == Approx(std::pow(std::max(0.0, glm::dot(vectors[i][0], vectors[i][2])), 30)).margin(1e-12));
  }
  CHECK(operators(design.light_maps->fill) == Operators{7, 4, 0, 0, 1, 0});
}

TEST_CASE("Kugler 1998 in double precision is the illumination equation, up to bumps steeper than its map holds") {
  const Material material;
  for (const char* frame : {"face", "vertex", "pixel"})
    CHECK(accuracy(designed("kugler1998", {{"frame", frame}}, material), material, 8, anywhere).real_to_exact_db > 120);
  CHECK(accuracy(designed("kugler1998", {{"frame", "none"}}, material), material, 8, anywhere).real_to_exact_db < 30);
  CHECK(accuracy(designed("kugler1998", {{"max_tilt", "10"}}, material), material, 8, anywhere).real_to_exact_db < 40);
}

TEST_CASE("fixed point keeps Kugler 1998 near its formula, and nearer with finer maps") {
  const Material material;
  const auto db = [&](Settings settings) {
    return accuracy(designed("kugler1998", settings, material), material, 20, anywhere).fixed_to_real_db;
  };
  CHECK(db({}) > 28);
  CHECK(db({{"map_holds", "change"}}) > db({}) + 1);
  CHECK(db({{"map_phi_bits", "6"}, {"map_theta_bits", "7"}, {"map_tilt_bits", "5"}, {"map_word_bits", "12"}}) > db({}) + 6);
}
