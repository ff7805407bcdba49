// What schemes with a y-pole bump map share: angles of N that follow the tangent, and sums of words read.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "schemes/common/sums_reads.h"
#include "schemes/common/y_pole_map.h"
#include "schemes/common/y_pole_vectors.h"
#include "testbench/tests/schemes/vector_bench.h"
#include "testbench/tests/schemes/y_pole_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

/// The vertex program's angles of N for a chart.
Netlist angles_netlist(InPlane frame) {
  Netlist n("vertex");
  const VectorWires normal = input_vector(n, "N", real());
  const VectorWires tangent = input_vector(n, "T", real());
  const PolarWires polar = chart_angles(n, "N_polar", normal, tangent, frame, vertex_polar_formats(), real(), 1e-6);
  n.output("N.phi", polar.phi);
  n.output("N.theta", polar.theta);
  return n;
}

std::vector<Polar> angles_of(const std::vector<Point>& points, InPlane frame) {
  Planes planes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    set_vector(planes, "N", i, points[i].normal);
    set_vector(planes, "T", i, points[i].tangent);
  }
  run(angles_netlist(frame), Arithmetic::real, planes, static_cast<int>(points.size()));
  std::vector<Polar> angles;
  for (std::size_t i = 0; i < points.size(); ++i) angles.push_back({planes["N.phi"][i], planes["N.theta"][i]});
  return angles;
}

double turns_between(double a, double b) {
  return std::abs(a - b - std::floor(a - b + 0.5));
}

}  // namespace

TEST_CASE("angles that follow a chart turn N to z and T to its axis, also on the z axis") {
  Random random(3);
  for (const InPlane frame : {InPlane::parallel, InPlane::meridian}) {
    std::vector<Point> points;
    for (int i = 0; i < 192; ++i) points.push_back(frame == InPlane::parallel ? point_on_parallel(random) : point_on_meridian(random));
    for (int i = 0; i < 64; ++i) points.push_back(point_on_axis(random, i % 2 == 0 ? 1 : -1));
    const std::vector<Polar> angles = angles_of(points, frame);
    for (std::size_t i = 0; i < points.size(); ++i) {
      CAPTURE(i);
      CHECK(glm::length(rotated(points[i].normal, angles[i]) - glm::dvec3(0, 0, 1)) < 1e-12);
      const glm::dvec3 axis = frame == InPlane::parallel ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
      CHECK(glm::length(rotated(points[i].tangent, angles[i]) - axis) < 1e-12);
    }
  }
}

TEST_CASE("angles that follow a chart of parallels run round the tube of a torus without a jump") {
  constexpr double two_pi = 6.283185307179586476925;
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) {
    const double s = 0.7, t = two_pi * i / block_lanes;
    Point p;
    p.normal = {std::cos(s) * std::cos(t), std::sin(s) * std::cos(t), std::sin(t)};
    p.tangent = {-std::sin(s), std::cos(s), 0};
    points.push_back(p);
  }
  const std::vector<Polar> angles = angles_of(points, InPlane::parallel);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    CHECK(turns_between(angles[i].phi, 0.7 / two_pi) < 1e-9);
    CHECK(turns_between(angles[i].theta, angles[(i + 1) % angles.size()].theta) < 1.01 / block_lanes);
  }
}

TEST_CASE("a y-pole map of a chart of parallels holds the normal turned by a quarter") {
  YPoleSettings settings;
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 n = random.point(1.5).bump;
    double texel[2];
    settings.chart = Chart::parallel;
    y_pole_map(settings).encode(n, texel);
    CHECK(glm::length(from_y_pole(texel[0], texel[1]) - glm::dvec3(-n.y, n.x, n.z)) < 1e-12);
    settings.chart = Chart::meridian;
    y_pole_map(settings).encode(n, texel);
    CHECK(glm::length(from_y_pole(texel[0], texel[1]) - n) < 1e-12);
    for (const double angle : texel) CHECK(std::abs(angle) <= 0.25);
  }
}

TEST_CASE("no unit of a scheme of sums delivers what an interpolant is called, wherever the angles come from") {
  for (const char* id : {"yp6", "yp4", "yp2", "yp0", "ya4", "exact10", "yp6g"})
    for (const char* angles : {"vertex", "pixel"}) {
      CAPTURE(id, angles);
      const Design design = designed(id, {{"angles", angles}});
      std::set<std::string> names;
      for (const Interpolant& interpolant : design.interpolants) names.insert(interpolant.name);
      for (const Netlist* unit : {&design.environment, &design.illumination})
        for (const Netlist::Port& port : unit->outputs()) CHECK(names.insert(port.name).second);
    }
}

TEST_CASE("a sum of words is exact and takes an adder less than words") {
  Random random(5);
  for (int added = 1; added <= 8; ++added)
    for (int subtracted = 0; subtracted <= 8; ++subtracted) {
      CAPTURE(added, subtracted);
      const int words = added + subtracted;
      int halvings = 0;  // the sum must stay below 2
      while (1 << halvings < words) ++halvings;
      Netlist n("sum");
      SineReads reads(n, {turns(12), 10, 12, 1});
      std::vector<Wire> plus, minus;
      Planes planes;
      Plane expected{};
      for (int i = 0; i < words; ++i) {
        const std::string name = "word_" + std::to_string(i);
        (i < added ? plus : minus).push_back(n.input(name, reads.word()));
        for (double& value : planes[name]) value = to_double(quantise(random.uniform(-1, 1), reads.word()), reads.word());
        for (std::size_t lane = 0; lane < expected.size(); ++lane) expected[lane] += (i < added ? 1 : -1) * planes[name][lane];
      }
      n.output("sum", reads.sum("sum", plus, minus, halvings));
      CHECK(count(n).adders == words - 1);
      for (double& value : expected) value = std::ldexp(value, -halvings);
      for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
        run(n, arithmetic, planes);
        const double worst = std::inner_product(
            expected.begin(), expected.end(), planes["sum"].begin(), 0.0, [](double a, double b) { return std::max(a, b); },
            [](double a, double b) { return std::abs(a - b); });
        CHECK(worst < (arithmetic == Arithmetic::fixed ? 1e-300 : 1e-14));
      }
    }
}
