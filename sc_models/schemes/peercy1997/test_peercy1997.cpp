#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/inventory.h"
#include "testbench/tests/schemes/scheme_bench.h"

using namespace bump;
using namespace bump::bench;

namespace {

void require_counts(const Netlist& netlist, int multipliers, int adders, int dividers, int square_roots, int tables) {
  const Inventory c = count(netlist, Portion::published);
  CHECK(c.multipliers == multipliers);
  CHECK(c.adders == adders);
  CHECK(c.dividers == dividers);
  CHECK(c.square_roots == square_roots);
  CHECK(c.tables == tables);
  CHECK(c.maps == 0);
}

}  // namespace

TEST_CASE("Peercy 1997 is built of the operators that Table 1 of Lee 2007 charges it") {
  require_counts(designed("peercy1997").environment, 27, 18, 9, 3, 0);
  require_counts(designed("peercy1997", {{"transform", "vertex"}}).environment, 9, 6, 9, 3, 0);
  for (const char* transform : {"pixel", "vertex"})
    require_counts(designed("peercy1997", {{"transform", transform}}).illumination, 7, 5, 0, 0, 1);
}

TEST_CASE("a reciprocal root table replaces the dividers of Peercy 1997 by multipliers") {
  require_counts(designed("peercy1997", {{"normaliser", "table"}}).environment, 36, 18, 0, 0, 3);
  require_counts(designed("peercy1997", {{"normaliser", "table"}, {"transform", "vertex"}}).environment, 18, 6, 0, 0, 3);
}

TEST_CASE("Peercy 1997 interpolates five vectors, or two when the vertices transform") {
  CHECK(designed("peercy1997").interpolants.size() == 15);
  CHECK(designed("peercy1997", {{"transform", "vertex"}}).interpolants.size() == 6);
}

TEST_CASE("Peercy 1997 in double precision is the illumination equation") {
  const Material material;
  for (const char* transform : {"pixel", "vertex"})
    for (const char* normaliser : {"divider", "table"}) {
      const Design design = designed("peercy1997", {{"transform", transform}, {"normaliser", normaliser}}, material);
      CHECK(accuracy(design, material, 8, [](Random& r) { return r.point(); }).real_to_exact_db > 250);
      const auto unlit_and_mirrored = [](Random& r) {
        Point p = r.point();
        p.light *= -7;  // a point light at some distance, behind the surface
        p.view *= 0.2;
        p.binormal = -p.binormal;
        return p;
      };
      CHECK(accuracy(design, material, 8, unlit_and_mirrored).real_to_exact_db > 250);
    }
}

TEST_CASE("Peercy 1997 normalises shortened vectors") {
  const Design design = designed("peercy1997", {{"transform", "vertex"}});
  for (const Arithmetic arithmetic : {Arithmetic::real, Arithmetic::fixed}) {
    Random random(5);
    Planes planes;
    std::vector<glm::dvec3> light;
    for (std::size_t i = 0; i < block_lanes; ++i) {
      light.push_back(random.direction());
      const double length = random.uniform(0.5, 1);  // as interpolation and filtering leave it
      for (const std::string name : {"L_ts", "H_ts", "map"}) {
        planes[name + ".x"][i] = length * light.back().x;
        planes[name + ".y"][i] = length * light.back().y;
        planes[name + ".z"][i] = length * light.back().z;
      }
    }
    run(design.environment, arithmetic, planes);
    const double tolerance = arithmetic == Arithmetic::real ? 1e-6 : 0.25;
    for (std::size_t i = 0; i < light.size(); ++i)
      for (const std::string name : {"L_unit", "H_unit", "N_unit"})
        CHECK(degrees_between(glm::normalize(glm::dvec3(planes[name + ".x"][i], planes[name + ".y"][i], planes[name + ".z"][i])),
                              light[i]) < tolerance);
  }
}

TEST_CASE("Peercy 1997 gains six decibels a bit") {
  const Material material;
  const auto db = [&](const char* bits) {
    const Design design = designed("peercy1997", {{"word_bits", bits}, {"texel_bits", bits}, {"light_table_bits", "12"}}, material);
    return accuracy(design, material, 20, [](Random& r) { return r.point(); }).fixed_to_exact_db;
  };
  const double eight = db("8"), ten = db("10"), twelve = db("12");
  CHECK(eight > 33);
  CHECK(ten - eight == Approx(12).margin(3));
  CHECK(twelve - ten == Approx(12).margin(3));
}

TEST_CASE("fixed point keeps Peercy 1997 above 50 dB at its defaults") {
  const Material material;
  for (const char* transform : {"pixel", "vertex"})
    for (const char* normaliser : {"divider", "table"}) {
      const Design design = designed("peercy1997", {{"transform", transform}, {"normaliser", normaliser}}, material);
      CHECK(accuracy(design, material, 30, [](Random& r) { return r.point(); }).fixed_to_real_db > 50);
    }
}
