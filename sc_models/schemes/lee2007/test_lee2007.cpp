#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "datapath/duplicates.h"
#include "datapath/inventory.h"
#include "testbench/tests/schemes/polar_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

struct Statistics {
  double mean = 0, rms = 0, max = 0;
};

/// Angles between computed and true A' over random pairs at most 90 degrees apart; `upper` keeps both in the object's upper hemisphere.
Statistics rotation_error(Settings settings, bool upper, Arithmetic arithmetic = Arithmetic::real, int blocks = 150) {
  const Design design = designed("lee2007", settings);
  Random random(7);
  Statistics s;
  for (int block = 0; block < blocks; ++block) {
    Planes planes;
    std::vector<glm::dvec3> expected;
    while (expected.size() < block_lanes) {
      glm::dvec3 normal = random.direction(), a = random.direction();
      if (upper) normal.z = std::abs(normal.z), a.z = std::abs(a.z);
      if (glm::dot(normal, a) < 0) continue;
      set_polar(planes, "N", expected.size(), polar_of(normal));
      set_polar(planes, "L", expected.size(), polar_of(a));
      set_polar(planes, "H", expected.size(), polar_of(a));
      expected.push_back(rotated(a, polar_of(normal)));
    }
    run(design.environment, arithmetic, planes);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double error = degrees_between(from_polar(planes["L_ref.phi"][i], planes["L_ref.theta"][i]), expected[i]);
      s.mean += error;
      s.rms += error * error;
      s.max = std::max(s.max, error);
    }
  }
  const double count = blocks * block_lanes;
  return {s.mean / count, std::sqrt(s.rms / count), s.max};
}

void require_counts(const Netlist& netlist, int multipliers, int adders, int tables) {
  const Inventory c = count(netlist, Portion::published);
  CHECK(c.multipliers == multipliers);
  CHECK(c.adders == adders);
  CHECK(c.tables == tables);
  CHECK(c.dividers == 0);
  CHECK(c.square_roots == 0);
  CHECK(c.maps == 0);
}

/// The value of a node in degrees, brought to (-180, 180].
double degrees(double turns) {
  return 360 * (turns - std::floor(turns + 0.5));
}

}  // namespace

TEST_CASE("Lee 2007 is built of the operators that its Table 1 lists") {
  const Design eleven = designed("lee2007"), thirteen = designed("lee2007", {{"form", "13"}});
  require_counts(eleven.environment, 6, 16, 12);
  require_counts(eleven.illumination, 2, 11, 8);
  require_counts(thirteen.environment, 6, 16, 12);
  require_counts(thirteen.illumination, 2, 13, 8);
}

TEST_CASE("sign corrections and widths cost Lee 2007 no operator") {
  for (const char* fix : {"abs_fix", "quadrant_fix", "hemisphere_bit"})
    require_counts(designed("lee2007", {{fix, "false"}}).environment, 6, 16, 12);
  require_counts(designed("lee2007", {{"half_xy", "true"}}).environment, 6, 16, 12);
  require_counts(
      designed("lee2007", {{"angle_bits", "14"}, {"table_bits", "10"}, {"inverse_table_bits", "9"}, {"word_bits", "14"}}).environment, 6,
      16, 12);
  for (const char* angles : {"vertex", "pixel"}) require_counts(designed("lee2007", {{"angles", angles}}).environment, 6, 16, 12);
}

TEST_CASE("exactness costs Lee 2007 the operators that its page states") {
  require_counts(designed("lee2007", {{"x_prime", "exact"}, {"hemisphere_bit", "false"}}).environment, 10, 16, 15);
  require_counts(designed("lee2007", {{"x_prime", "exact"}}).environment, 14, 18, 15);
  require_counts(designed("lee2007", {{"eq16", "exact"}}).environment, 4, 20, 18);
  require_counts(designed("lee2007", {{"x_prime", "exact"}, {"eq16", "exact"}}).environment, 12, 22, 21);
}

TEST_CASE("the in-plane angle of Lee 2007 is one adder beside the published design") {
  for (const char* frame : {"face", "pixel"}) {
    const Inventory addition = count(designed("lee2007", {{"frame", frame}}).illumination, Portion::addition);
    CHECK(addition.adders == 1);
    CHECK(addition.multipliers + addition.tables == 0);
  }
  CHECK(count(designed("lee2007", {{"frame", "none"}}).illumination, Portion::addition).adders == 0);
}

TEST_CASE("the twelve environment tables of Lee 2007 are 8 Kbytes") {
  CHECK(count(designed("lee2007").environment, Portion::published).table_bits == 8192 * 8);
  CHECK(count(designed("lee2007", {{"word_bits", "12"}}).environment, Portion::published).table_bits == 8192 * 6);
  // 5 columns of sines, cosines and reciprocals and 3 of inverse functions, twice.
  CHECK(count(designed("lee2007", {{"table_bits", "6"}, {"inverse_table_bits", "9"}}).environment, Portion::published).table_bits ==
        2 * 16 * (5 * 64 + 3 * 512));
}

TEST_CASE("Lee 2007 reproduces the golden vectors of its rotation") {
  struct Golden {
    double a_phi, a_theta, n_phi, n_theta, X, Y, theta_x, Z, y, y_k, prop, phi, theta;
  };
  // Computed once by a program of its own, to the digits shown.
  const std::vector<Golden> golden{{40, 30, 0, 0, 70, -10, 22.521, 22.521, 0.321, 0.348, 0.2262, 40.00, 37.79},
                                   {40, 30, 0, 30, 70, -10, 22.521, -7.479, 0.321, 0.324, 0.2102, 112.05, 24.82},
                                   {40, 30, 70, 30, 0, 60, 25.659, -4.341, -0.250, 0.251, 0.1613, -106.85, 18.16},
                                   {60, 45, 20, 25, 85, 5, 32.798, 7.798, 0.455, 0.459, 0.3034, 73.38, 32.74},
                                   {50, 60, -100, 40, 210, -90, -48.590, -88.590, 0.433, 17.602, 1.0000, 156.58, 90.00},
                                   {20, 80, 95, 35, 5, 155, 14.767, -20.233, -0.951, 1.014, 1.0000, -109.98, 90.00}};
  const Design design = designed("lee2007");
  for (const std::string vector : {"L", "H"}) {
    Planes planes;
    for (std::size_t i = 0; i < golden.size(); ++i) {
      const Golden& g = golden[i];
      for (const char* name : {"L", "H"}) set_polar(planes, name, i, {0.1, 0.1});
      set_polar(planes, vector, i, {g.a_phi / 360, g.a_theta / 360});
      set_polar(planes, "N", i, {g.n_phi / 360, g.n_theta / 360});
    }
    const Netlist& netlist = design.environment;
    const auto evaluator = run(netlist, Arithmetic::real, planes, static_cast<int>(golden.size()));
    for (std::size_t i = 0; i < golden.size(); ++i) {
      const Golden& g = golden[i];
      const auto node = [&](const std::string& name) { return evaluator->value(netlist.find(vector + "." + name), static_cast<int>(i)); };
      CAPTURE(vector, i);
      CHECK(degrees(node("X")) == Approx(degrees(g.X / 360)).margin(0.005));
      CHECK(degrees(node("Y")) == Approx(degrees(g.Y / 360)).margin(0.005));
      CHECK(degrees(node("theta_x")) == Approx(g.theta_x).margin(0.00051));
      CHECK(degrees(node("Z")) == Approx(g.Z).margin(0.00051));
      CHECK(node("y") == Approx(g.y).margin(0.00051));
      CHECK(node("y_k") == Approx(g.y_k).margin(0.00051));
      CHECK(node("prop") == Approx(g.prop).margin(0.000051));
      CHECK(degrees(node("phi_ref")) == Approx(g.phi).margin(0.0051));
      CHECK(degrees(node("theta_ref")) == Approx(g.theta).margin(0.0051));
    }
  }
}

TEST_CASE("with both mistakes mended the rotation of Lee 2007 is a rotation") {
  const Design design = designed("lee2007", {{"x_prime", "exact"}, {"eq16", "exact"}});
  CHECK(worst_rotation_error(design.environment, Arithmetic::real) < 1e-10);
}

TEST_CASE("the rotation of Lee 2007 errs as measured independently") {
  SECTION("recommended reading, upper hemisphere") {
    const Statistics s = rotation_error({}, true);
    CHECK(s.mean == Approx(15.8).margin(0.3));
    CHECK(s.rms == Approx(19.8).margin(0.3));
    CHECK(s.max == Approx(59.5).margin(1.5));
  }
  SECTION("recommended reading, whole sphere") {
    const Statistics s = rotation_error({}, false);
    CHECK(s.mean == Approx(17.0).margin(0.3));
    CHECK(s.rms == Approx(21.1).margin(0.3));
    CHECK(s.max == Approx(59.4).margin(1.5));
  }
  SECTION("without the hemisphere bit") {
    CHECK(rotation_error({{"hemisphere_bit", "false"}}, true).mean == Approx(15.8).margin(0.3));
    CHECK(rotation_error({{"hemisphere_bit", "false"}}, false).mean == Approx(47).margin(0.9));
  }
  SECTION("quadrant folded only") {
    const Statistics s = rotation_error({{"hemisphere_bit", "false"}, {"abs_fix", "false"}}, true);
    CHECK(s.mean == Approx(57).margin(1));
    CHECK(s.rms == Approx(75).margin(1));
  }
  SECTION("literal but for the halving") {
    const Statistics s = rotation_error({{"hemisphere_bit", "false"}, {"abs_fix", "false"}, {"quadrant_fix", "false"}}, true);
    CHECK(s.mean == Approx(76).margin(1));
    CHECK(s.rms == Approx(96).margin(1));
  }
  SECTION("literal") {
    const Statistics s =
        rotation_error({{"hemisphere_bit", "false"}, {"abs_fix", "false"}, {"quadrant_fix", "false"}, {"half_xy", "true"}}, true);
    CHECK(s.mean == Approx(48).margin(1));
    CHECK(s.rms == Approx(55).margin(1));
  }
  SECTION("exact Eq 16 alone helps little") {
    const Statistics s = rotation_error({{"eq16", "exact"}}, true);
    CHECK(s.mean == Approx(13.6).margin(0.3));
    CHECK(s.rms == Approx(18.6).margin(0.3));
  }
  SECTION("exact x' alone bounds the error at 8.6 degrees") {
    const Statistics s = rotation_error({{"x_prime", "exact"}}, false);
    CHECK(s.mean == Approx(4.1).margin(0.15));
    CHECK(s.max < 8.65);
    CHECK(s.max > 8.3);
  }
}

TEST_CASE("both illumination forms of Lee 2007 are the dot product") {
  const Material material{0, 1, 0, 1};  // intensity = N'.L' where lit
  const Design eleven = designed("lee2007", {{"frame", "none"}}, material),
               thirteen = designed("lee2007", {{"frame", "none"}, {"form", "13"}}, material);
  Random random(3);
  Planes planes;
  std::vector<double> expected;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const glm::dvec3 light = random.direction(), half = random.direction(), normal = random.direction();
    set_polar(planes, "L_ref", i, polar_of(light));
    set_polar(planes, "H_ref", i, polar_of(half));
    set_polar(planes, "map", i, polar_of(normal));
    expected.push_back(std::max(0.0, glm::dot(light, normal)));
  }
  Planes other = planes;
  run(eleven.illumination, Arithmetic::real, planes);
  run(thirteen.illumination, Arithmetic::real, other);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(planes["intensity"][i] == Approx(expected[i]).margin(1e-13));
    CHECK(other["intensity"][i] == Approx(expected[i]).margin(1e-13));
  }
}

TEST_CASE("vertex program, frame and illumination of Lee 2007 are exact when its rotation is") {
  const Material material;
  for (const char* angles : {"vertex", "pixel"})
    for (const char* frame : {"face", "pixel"}) {
      const Design design = designed("lee2007", {{"x_prime", "exact"}, {"eq16", "exact"}, {"angles", angles}, {"frame", frame}}, material);
      CHECK(accuracy(design, material, 8, [](Random& r) { return r.point(); }).real_to_exact_db > 180);
      // Unlit sides: a vector below the horizon must not shine from above.
      CHECK(accuracy(design, material, 8, [](Random& r) {
              Point p = r.point();
              p.light = -p.light;
              return p;
            }).real_to_exact_db > 180);
    }
}

TEST_CASE("the frame of Lee 2007 is right on the polar axis, where azimuth means nothing") {
  const Material material;
  for (const char* angles : {"vertex", "pixel"}) {
    const Design design = designed("lee2007", {{"x_prime", "exact"}, {"eq16", "exact"}, {"angles", angles}}, material);
    for (const double side : {1.0, -1.0}) {
      const Accuracy a = accuracy(design, material, 8, [side](Random& r) { return point_on_axis(r, side); });
      CHECK(a.real_to_exact_db > 180);
      CHECK(a.fixed_to_exact_db > 40);
    }
  }
}

TEST_CASE("a mirrored texture chart is shaded right with the mirror flag only") {
  const Material material;
  const auto mirrored = [](Random& r) {
    Point p = r.point();
    p.binormal = -p.binormal;
    return p;
  };
  const auto db = [&](const char* mirror) {
    return accuracy(designed("lee2007", {{"x_prime", "exact"}, {"eq16", "exact"}, {"mirror", mirror}}, material), material, 8, mirrored)
        .real_to_exact_db;
  };
  CHECK(db("true") > 180);
  CHECK(db("false") < 40);
}

TEST_CASE("fixed point keeps Lee 2007 near its own formula") {
  const Material material;
  const auto everywhere = [](Random& r) { return r.point(); };
  // Away from the object's equator, where the formula itself jumps.
  const auto upper = [](Random& r) {
    Point p = r.point();
    p.normal.z = std::abs(p.normal.z);
    for (glm::dvec3* v : {&p.light, &p.view}) {
      v->z = std::max(std::abs(v->z), 0.05);
      *v = glm::normalize(*v);
      if (glm::dot(*v, p.normal) < 0) *v = glm::normalize(glm::dvec3(-v->x, -v->y, v->z));
    }
    p.tangent = glm::normalize(glm::cross(r.direction(), p.normal));
    p.binormal = glm::cross(p.normal, p.tangent);
    return p;
  };
  CHECK(accuracy(designed("lee2007", {}, material), material, 30, everywhere).fixed_to_real_db > 36);
  CHECK(accuracy(designed("lee2007", {}, material), material, 30, upper).fixed_to_real_db > 49);
  CHECK(accuracy(designed("lee2007", {{"form", "13"}}, material), material, 30, upper).fixed_to_real_db > 49);
  const Settings wide{{"angle_bits", "16"},     {"table_bits", "12"},       {"inverse_table_bits", "12"}, {"word_bits", "20"},
                      {"texel_phi_bits", "12"}, {"texel_theta_bits", "12"}, {"light_table_bits", "12"}};
  CHECK(accuracy(designed("lee2007", wide, material), material, 30, upper).fixed_to_real_db > 68);
}

TEST_CASE("table size does not change what the rotation of Lee 2007 is worth") {
  const Statistics exact = rotation_error({}, false, Arithmetic::real, 60), hardware = rotation_error({}, false, Arithmetic::fixed, 60);
  const Statistics coarse = rotation_error({{"table_bits", "6"}, {"inverse_table_bits", "6"}}, false, Arithmetic::fixed, 60);
  CHECK(std::abs(hardware.rms - exact.rms) < 0.2);
  CHECK(std::abs(coarse.rms - exact.rms) < 0.8);
}
