// The parameters that the units declare, and that their configurations read them.

#include <catch2/catch.hpp>

#include "units/colour_unit.h"
#include "units/interpolators.h"
#include "units/rasterizer.h"
#include "units/texture_fetch.h"
#include "units/triangle_setup.h"
#include "units/vertex_processor.h"

namespace bump {
namespace {

Parameters all() {
  Parameters p;
  VertexProcessorConfig::declare(p);
  TriangleSetupConfig::declare(p);
  RasterizerConfig::declare(p);
  InterpolatorsConfig::declare(p);
  TextureFetchConfig::declare(p);
  ColourUnitConfig::declare(p);
  return p;
}

TEST_CASE("an untouched configuration gives the units their own defaults") {
  const Configuration c(all());
  CHECK(VertexProcessorConfig(c).alus == VertexProcessorConfig().alus);
  CHECK(VertexProcessorConfig(c).cache_entries == VertexProcessorConfig().cache_entries);
  CHECK(VertexProcessorConfig(c).latency == VertexProcessorConfig().latency);
  CHECK(TriangleSetupConfig(c).interval == TriangleSetupConfig().interval);
  CHECK(TriangleSetupConfig(c).latency == TriangleSetupConfig().latency);
  CHECK(TriangleSetupConfig(c).cull_back == TriangleSetupConfig().cull_back);
  CHECK(TriangleSetupConfig(c).guard_band == TriangleSetupConfig().guard_band);
  CHECK(TriangleSetupConfig(c).subpixel_bits == TriangleSetupConfig().subpixel_bits);
  CHECK(RasterizerConfig(c).order == RasterizerConfig().order);
  CHECK(RasterizerConfig(c).tile == RasterizerConfig().tile);
  CHECK(RasterizerConfig(c).subpixel_bits == RasterizerConfig().subpixel_bits);
  CHECK(RasterizerConfig(c).early_z == RasterizerConfig().early_z);
  CHECK(RasterizerConfig(c).latency == RasterizerConfig().latency);
  CHECK(InterpolatorsConfig(c).latency == InterpolatorsConfig().latency);
  CHECK(TextureFetchConfig(c).filter == TextureFetchConfig().filter);
  CHECK(TextureFetchConfig(c).footprints_per_cycle == TextureFetchConfig().footprints_per_cycle);
  CHECK(TextureFetchConfig(c).cache == TextureFetchConfig().cache);
  CHECK(ColourUnitConfig(c).bits == ColourUnitConfig().bits);
}

TEST_CASE("what is set is what the units read, and a cache that cannot be built is an input error") {
  Configuration c(all());
  const auto set = [&](const char* key, const char* value) { c.set_text(key, value, {"test", 0, 0}); };
  set("vertex_processor.alus", "7");
  set("triangle_setup.cull", "none");
  set("rasterizer.order", "tiled");
  set("rasterizer.subpixel_bits", "4");
  set("rasterizer.early_z", "false");
  set("texture_fetch.filter", "trilinear");
  set("texture_fetch.cache.ways", "3");
  set("colour_unit.bits", "10");
  CHECK(VertexProcessorConfig(c).alus == 7);
  CHECK(!TriangleSetupConfig(c).cull_back);
  CHECK(TriangleSetupConfig(c).subpixel_bits == 4);
  CHECK(RasterizerConfig(c).order == RasterizerConfig::Order::tiled);
  CHECK(!RasterizerConfig(c).early_z);
  CHECK(TextureFetchConfig(c).filter == Filter::trilinear);
  CHECK(TextureFetchConfig(c).cache.ways == 3);
  CHECK(ColourUnitConfig(c).bits == 10);
  set("texture_fetch.filter", "nearest");
  CHECK(TextureFetchConfig(c).filter == Filter::nearest);
  set("texture_fetch.cache.sets", "33");
  CHECK_THROWS_AS(TextureFetchConfig(c), Error);
}

TEST_CASE("a look-up takes at least a cycle to reach memory") {
  Configuration c(all());
  CHECK_THROWS_AS(c.set_text("memory.tag_latency", "0", {"test", 0, 0}), Error);
  c.set_text("memory.tag_latency", "1", {"test", 0, 0});
  CHECK(c.integer("memory.tag_latency") == 1);
}

}  // namespace
}  // namespace bump
