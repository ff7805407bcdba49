#include "testbench/tests/schemes/y_pole_bench.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

namespace bump::bench {

namespace {

constexpr double two_pi = 6.283185307179586476925;

Point with_tangent(Point p, const glm::dvec3& tangent) {
  p.tangent = glm::normalize(tangent);
  p.binormal = glm::cross(p.normal, p.tangent);
  return p;
}

Point mirrored(Point p) {
  p.binormal = -p.binormal;
  return p;
}

Point unlit(Point p) {
  p.light = -p.light;
  return p;
}

/// Whole design, double precision, against Eq 2.
double exact_db(const std::string& id, Settings settings, const std::function<Point(Random&)>& draw) {
  const Material material;
  return accuracy(designed(id, settings, material), material, 4, draw).real_to_exact_db;
}

/// Calls `visit` with every read of a table in both units.
template <class Visit>
void for_reads(const Design& design, const Visit& visit) {
  for (const Netlist* unit : {&design.environment, &design.illumination})
    for (const Node& node : unit->nodes())
      if (node.op == Op::table) visit(*unit->tables()[static_cast<std::size_t>(node.table)], node.second_port);
}

/// Of the ROMs of tables with these names.
std::int64_t rom_bits(const Design& design, const std::set<std::string>& names) {
  std::int64_t bits = 0;
  for_reads(design, [&](const Table& table, bool second_port) {
    if (!second_port && names.count(table.name) != 0) bits += table.bits();
  });
  return bits;
}

}  // namespace

glm::dvec3 from_y_pole(double psi, double latitude) {
  const double c = std::cos(two_pi * latitude);
  return {c * std::sin(two_pi * psi), std::sin(two_pi * latitude), c * std::cos(two_pi * psi)};
}

double YPoleInputs::dot(const glm::dvec3& v) const {
  return glm::dot(rotated(v, normal), from_y_pole(psi, latitude));
}

void set_inputs(Planes& planes, std::size_t lane, const YPoleInputs& in) {
  set_polar(planes, "N", lane, in.normal);
  set_polar(planes, "L", lane, polar_of(in.light));
  set_polar(planes, "H", lane, polar_of(in.half));
  planes["map.psi"][lane] = in.psi;
  planes["map.latitude"][lane] = in.latitude;
}

/// N'.L and N'.H of every lane, before they are clamped.
static std::vector<glm::dvec2> dots(const Design& design, Planes& planes, int lanes) {
  const auto environment = run(design.environment, Arithmetic::real, planes, lanes);
  const auto illumination = run(design.illumination, Arithmetic::real, planes, lanes);
  const bool in_environment = design.environment.find("N_L.dot") >= 0;
  const Netlist& netlist = in_environment ? design.environment : design.illumination;
  const Evaluator& evaluator = in_environment ? *environment : *illumination;
  const int light = netlist.find("N_L.dot"), half = netlist.find("N_H.dot");
  std::vector<glm::dvec2> found;
  for (int lane = 0; lane < lanes; ++lane) found.emplace_back(evaluator.value(light, lane), evaluator.value(half, lane));
  return found;
}

double worst_dot_error(const Design& design, int blocks) {
  Random random(41);
  double worst = 0;
  for (int block = 0; block < blocks; ++block) {
    Planes planes;
    std::vector<YPoleInputs> inputs;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      const auto turn = [&] { return random.uniform(-0.5, 0.5); };
      inputs.push_back({random.direction(), random.direction(), {turn(), turn()}, turn(), turn()});
      set_inputs(planes, i, inputs.back());
    }
    const std::vector<glm::dvec2> found = dots(design, planes, block_lanes);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      worst = std::max(worst, std::abs(found[i].x - inputs[i].dot(inputs[i].light)));
      worst = std::max(worst, std::abs(found[i].y - inputs[i].dot(inputs[i].half)));
    }
  }
  return worst;
}

void require_golden_dots(const Design& design) {
  struct Golden {
    Polar light, half, normal;  // degrees
    double psi, latitude, n_l, n_h;
  };
  const std::vector<Golden> golden{{{40, 30}, {0, 0}, {70, 30}, 20, 10, 0.83147, 0.63302},
                                   {{60, 45}, {20, 80}, {20, 25}, -35, -15, 0.46414, 0},
                                   {{50, 60}, {95, 35}, {-100, 40}, 5, 40, 0.14292, 0.04819},
                                   {{-170, 120}, {150, 75}, {160, -100}, 30, -20, -0.97106, -0.69943}};
  Planes planes;
  for (std::size_t i = 0; i < golden.size(); ++i) {
    const auto set = [&](const char* name, Polar degrees) { set_polar(planes, name, i, {degrees.phi / 360, degrees.theta / 360}); };
    set("L", golden[i].light);
    set("H", golden[i].half);
    set("N", golden[i].normal);
    planes["map.psi"][i] = golden[i].psi / 360;
    planes["map.latitude"][i] = golden[i].latitude / 360;
  }
  const std::vector<glm::dvec2> found = dots(design, planes, static_cast<int>(golden.size()));
  for (std::size_t i = 0; i < golden.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].x == Approx(golden[i].n_l).margin(5.1e-6));
    CHECK(found[i].y == Approx(golden[i].n_h).margin(5.1e-6));
  }
}

void require_exact_charts(const std::string& id) {
  for (const char* angles : {"vertex", "pixel"}) {
    CAPTURE(angles);
    CHECK(exact_db(id, {{"angles", angles}}, point_on_parallel) > 200);
    CHECK(exact_db(id, {{"angles", angles}}, [](Random& r) { return unlit(point_on_parallel(r)); }) > 200);
    CHECK(exact_db(id, {{"angles", angles}, {"frame", "meridian"}}, point_on_meridian) > 200);
    CHECK(exact_db(id, {{"angles", angles}, {"frame", "pixel"}}, anywhere) > 200);
    for (const double side : {1.0, -1.0})
      for (const char* frame : {"parallel", "meridian", "pixel"}) {
        CAPTURE(side, frame);
        CHECK(exact_db(id, {{"angles", angles}, {"frame", frame}}, [side](Random& r) { return point_on_axis(r, side); }) > 200);
      }
  }
  // The chart that the map is not made for.
  CHECK(exact_db(id, {}, point_on_meridian) < 40);
  CHECK(exact_db(id, {{"frame", "meridian"}}, point_on_parallel) < 40);
}

void require_mirrored_charts(const std::string& id) {
  const auto db = [&](const char* mirror, const char* frame, Point (*draw)(Random&)) {
    return exact_db(id, {{"mirror", mirror}, {"frame", frame}}, [draw](Random& r) { return mirrored(draw(r)); });
  };
  CHECK(db("true", "parallel", point_on_parallel) > 200);
  CHECK(db("true", "meridian", point_on_meridian) > 200);
  CHECK(db("true", "pixel", anywhere) > 200);
  CHECK(db("false", "parallel", point_on_parallel) < 40);
  CHECK(db("false", "pixel", anywhere) < 40);
  CHECK(exact_db(id, {{"mirror", "true"}}, point_on_parallel) > 200);
}

void require_six_decibels_of_sums(const std::string& id) {
  const Material material;
  const Scheme& scheme = find_scheme(id);
  const auto db = [&](const char* bits, const char* table, const char* texel) {
    Configuration configuration =
        configured(scheme, {{"angle_bits", bits}, {"word_bits", bits}, {"table_bits", table}, {"light_table_bits", "12"}});
    for (const auto& [key, value] :
         {std::pair{".inverse_table_bits", table}, {".texel_psi_bits", texel}, {".texel_latitude_bits", texel}, {".texel_bits", texel}})
      if (configuration.parameters().all().count(id + key) != 0) configuration.set_text(id + key, value, Location("test"));
    return accuracy(scheme.design(configuration, material), material, 20, point_on_parallel).fixed_to_exact_db;
  };
  const double ten = db("10", "8", "9"), twelve = db("12", "10", "11"), fourteen = db("14", "12", "13");
  CAPTURE(ten, twelve, fourteen);
  CHECK(ten > 46);
  CHECK(twelve - ten == Approx(12).margin(2.5));
  CHECK(fourteen - twelve == Approx(12).margin(2.5));
}

void require_ports_change_nothing(const std::string& id) {
  const Design one = designed(id), two = designed(id, {{"ports", "2"}});
  Random random(43);
  std::vector<Point> points;
  for (int i = 0; i < block_lanes; ++i) points.push_back(point_on_parallel(random));
  const bool same = shade(one, Arithmetic::fixed, points).at("intensity") == shade(two, Arithmetic::fixed, points).at("intensity");
  CHECK(same);
  std::set<std::string> shared;
  for_reads(two, [&](const Table& table, bool second_port) {
    if (second_port) shared.insert(table.name);
  });
  REQUIRE(!shared.empty());
  CHECK(2 * rom_bits(two, shared) >= rom_bits(one, shared));
  CHECK(100 * rom_bits(two, shared) < 62 * rom_bits(one, shared));
}

int columns_read(const Netlist& netlist) {
  return static_cast<int>(
      std::count_if(netlist.nodes().begin(), netlist.nodes().end(), [](const Node& node) { return node.op == Op::column; }));
}

Point point_on_parallel(Random& r) {
  const Point p = r.point();
  const double side = r.uniform(-1, 1) < 0 ? -1 : 1;
  return with_tangent(p, side * glm::cross(glm::dvec3(0, 0, 1), p.normal));
}

Point point_on_meridian(Random& r) {
  const Point p = r.point();
  const double side = r.uniform(-1, 1) < 0 ? -1 : 1;
  return with_tangent(p, side * glm::cross(glm::cross(glm::dvec3(0, 0, 1), p.normal), p.normal));
}

}  // namespace bump::bench
