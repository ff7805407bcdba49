#include "testbench/tests/schemes/polar_bench.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace bump::bench {

namespace {

constexpr double two_pi = 6.283185307179586476925;

}  // namespace

Polar polar_of(const glm::dvec3& v) {
  return {std::atan2(v.y, v.x) / two_pi, std::atan2(std::hypot(v.x, v.y), v.z) / two_pi};
}

void set_polar(Planes& planes, const std::string& name, std::size_t lane, Polar p) {
  planes[name + ".phi"][lane] = p.phi;
  planes[name + ".theta"][lane] = p.theta;
}

glm::dvec3 rotated(const glm::dvec3& a, Polar n) {
  const double c = std::cos(two_pi * n.phi), s = std::sin(two_pi * n.phi), ct = std::cos(two_pi * n.theta), st = std::sin(two_pi * n.theta);
  const double x = c * a.x + s * a.y, y = c * a.y - s * a.x;
  return {x * ct - a.z * st, y, x * st + a.z * ct};
}

double worst_rotation_error(const Netlist& environment, Arithmetic arithmetic, int blocks) {
  Random random(11);
  double worst = 0;
  for (int block = 0; block < blocks; ++block) {
    Planes planes;
    std::vector<glm::dvec3> light, half;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const Polar normal = polar_of(random.direction());
      const glm::dvec3 l = random.direction(), h = random.direction();
      set_polar(planes, "N", i, normal);
      set_polar(planes, "L", i, polar_of(l));
      set_polar(planes, "H", i, polar_of(h));
      light.push_back(rotated(l, normal));
      half.push_back(rotated(h, normal));
    }
    run(environment, arithmetic, planes);
    for (std::size_t i = 0; i < light.size(); ++i) {
      worst = std::max(worst, glm::length(from_polar(planes["L_ref.phi"][i], planes["L_ref.theta"][i]) - light[i]));
      worst = std::max(worst, glm::length(from_polar(planes["H_ref.phi"][i], planes["H_ref.theta"][i]) - half[i]));
    }
  }
  return worst;
}

const std::vector<GoldenRotation>& golden_rotations() {
  static const std::vector<GoldenRotation> golden{{{40, 30}, {0, 0}, {40.0, 30.0}},       {{40, 30}, {0, 30}, {107.5, 19.69}},
                                                  {{40, 30}, {70, 30}, {-103.06, 14.87}}, {{60, 45}, {20, 25}, {67.09, 29.57}},
                                                  {{50, 60}, {-100, 40}, {154.2, 95.69}}, {{20, 80}, {95, 35}, {-83.45, 73.24}}};
  return golden;
}

void require_golden_rotations(const Netlist& environment) {
  for (const std::string vector : {"L", "H"}) {
    Planes planes;
    for (std::size_t i = 0; i < golden_rotations().size(); ++i) {
      const auto turns_of = [](Polar p) { return Polar{p.phi / 360, p.theta / 360}; };
      for (const char* name : {"L", "H"}) set_polar(planes, name, i, {0.1, 0.1});
      set_polar(planes, vector, i, turns_of(golden_rotations()[i].a));
      set_polar(planes, "N", i, turns_of(golden_rotations()[i].normal));
    }
    run(environment, Arithmetic::real, planes, static_cast<int>(golden_rotations().size()));
    for (std::size_t i = 0; i < golden_rotations().size(); ++i) {
      CAPTURE(vector, i);
      CHECK(360 * planes[vector + "_ref.phi"][i] == Approx(golden_rotations()[i].expected.phi).margin(0.0051));
      CHECK(360 * planes[vector + "_ref.theta"][i] == Approx(golden_rotations()[i].expected.theta).margin(0.0051));
    }
  }
}

void require_counts(const Netlist& netlist, Portion portion, int multipliers, int adders, int tables, int dividers, int square_roots) {
  const Inventory c = count(netlist, portion);
  CHECK(c.multipliers == multipliers);
  CHECK(c.adders == adders);
  CHECK(c.tables == tables);
  CHECK(c.dividers == dividers);
  CHECK(c.square_roots == square_roots);
  CHECK(c.maps == 0);
}

void require_exact_illumination(const std::string& id, Settings settings) {
  const Material material;
  const Design design = designed(id, settings, material);
  const auto unlit = [](Random& r) {
    Point p = r.point();
    p.light = -p.light;
    return p;
  };
  CHECK(accuracy(design, material, 8, anywhere).real_to_exact_db > 200);
  CHECK(accuracy(design, material, 8, unlit).real_to_exact_db > 200);
  for (const double side : {1.0, -1.0})
    CHECK(accuracy(design, material, 4, [side](Random& r) { return point_on_axis(r, side); }).real_to_exact_db > 200);
}

void require_six_decibels_a_bit(const std::string& id) {
  const Material material;
  const auto db = [&](const char* word, const char* table) {
    const Design design = designed(id,
                                   {{"angle_bits", word},
                                    {"word_bits", word},
                                    {"table_bits", table},
                                    {"inverse_table_bits", table},
                                    {"texel_phi_bits", "12"},
                                    {"texel_theta_bits", "12"},
                                    {"light_table_bits", "12"}},
                                   material);
    return accuracy(design, material, 30, anywhere).fixed_to_exact_db;
  };
  const double ten = db("10", "8"), twelve = db("12", "10"), fourteen = db("14", "12");
  CHECK(ten > 48);
  CHECK(twelve - ten == Approx(12).margin(2.5));
  CHECK(fourteen - twelve == Approx(12).margin(2.5));
}

Point anywhere(Random& r) {
  return r.point();
}

Point mirrored_point(Random& r) {
  Point p = r.point();
  p.binormal = -p.binormal;
  return p;
}

Point point_on_axis(Random& r, double side) {
  Point p = r.point();
  const double psi = r.uniform(0, two_pi);
  p.normal = {r.uniform(-1e-17, 1e-17), r.uniform(-1e-17, 1e-17), side};
  p.tangent = {std::cos(psi), std::sin(psi), 0};
  p.binormal = glm::cross(p.normal, p.tangent);
  p.light.z = side * std::abs(p.light.z);
  p.view.z = side * std::abs(p.view.z);
  return p;
}

Point point_in_highlight(Random& r) {
  Point p = r.point();
  p.light = glm::normalize(p.normal + 0.15 * r.direction());
  p.view = glm::normalize(p.normal + 0.15 * r.direction());
  return p;
}

}  // namespace bump::bench
