#include <catch2/catch.hpp>

#include "testbench/tests/schemes/vector_bench.h"
#include "testbench/tests/units/samples.h"
#include "units/texture_fetch.h"

using namespace bump;
using namespace bump::bench;

namespace {

Point flat_point(Random& random) {
  Point p = random.point();
  p.bump = {0, 0, 1};
  return p;
}

/// Texels read per fragment of a small scene, and fragments.
std::pair<std::int64_t, std::int64_t> reads_of(const std::string& scheme) {
  const Scene scene = samples::crowded_scene();
  std::vector<Design> designs;
  designs.push_back(designed(scheme));
  const auto context = make_context(scene, std::move(designs), std::vector<int>(scene.objects.size(), 0), {});
  TextureFetch unit(context, TextureFetchConfig{});
  std::int64_t fragments = 0;
  for (const auto& block : samples::rasterize(context).blocks) {
    unit.process(*block);
    fragments += block->lanes;
    CHECK(block->texture_records.size() == static_cast<std::size_t>(block->lanes));
  }
  return {unit.counters().reads, fragments};
}

}  // namespace

TEST_CASE("Phong 1975 is three normalisers and the illumination of the Cartesian schemes") {
  CHECK(operators(designed("phong1975").environment) == Operators{9, 6, 9, 3, 0, 0});
  CHECK(operators(designed("phong1975").illumination) == Operators{7, 5, 0, 0, 1, 0});
}

TEST_CASE("Phong 1975 interpolates three vectors and reads no bump map") {
  const Design design = designed("phong1975");
  CHECK(design.interpolants.size() == 9);
  CHECK(design.map.channels.empty());
  const auto [reads, fragments] = reads_of("phong1975");
  REQUIRE(fragments > 1000);
  CHECK(reads == 4 * fragments);  // the bilinear footprint of the colour texture
  CHECK(reads_of("peercy1997").first == 8 * fragments);
}

TEST_CASE("Phong 1975 in double precision is the illumination equation of the flat surface") {
  const Material material;
  CHECK(accuracy(designed("phong1975"), material, 8, flat_point).real_to_exact_db > 250);
  const auto any_light = [](Random& r) {
    Point p = flat_point(r);
    p.light *= -7;  // a point light at some distance, behind the surface
    p.view *= 0.2;
    return p;
  };
  CHECK(accuracy(designed("phong1975"), material, 8, any_light).real_to_exact_db > 250);
}

TEST_CASE("Phong 1975 shades a bumpy surface as if it were flat") {
  const Design design = designed("phong1975");
  Random random(3);
  std::vector<Point> bumpy, flat;
  for (int i = 0; i < block_lanes; ++i) {
    bumpy.push_back(random.point());
    flat.push_back(bumpy.back());
    flat.back().bump = {0, 0, 1};
  }
  CHECK(shade(design, Arithmetic::fixed, bumpy).at("intensity") == shade(design, Arithmetic::fixed, flat).at("intensity"));
}

TEST_CASE("fixed point keeps Phong 1975 above 55 dB at its defaults, and gains six decibels a bit") {
  const Material material;
  const auto db = [&](const char* bits) {
    const Design design = designed("phong1975", {{"word_bits", bits}, {"light_table_bits", "12"}}, material);
    return accuracy(design, material, 20, flat_point).fixed_to_real_db;
  };
  CHECK(accuracy(designed("phong1975"), material, 20, flat_point).fixed_to_real_db > 55);
  CHECK(db("10") - db("8") == Approx(12).margin(3));
}
