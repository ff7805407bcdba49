// All units as SystemC modules joined by channels: the same frame as the behaviours called in a row, nothing lost on the way.

#include <catch2/catch.hpp>

#include "samples.h"
#include "units/colour_unit.h"
#include "units/environment_unit.h"
#include "units/frame_sink.h"
#include "units/illumination_unit.h"
#include "units/interpolators.h"
#include "units/modules.h"
#include "units/texture_fetch.h"

namespace bump {
namespace {

struct Plane {
  std::shared_ptr<const PipelineContext> context;
  std::shared_ptr<BlockPool> pool = samples::pool(*context);
  Failure failure;
  BlockFifo<TriangleBlock> transformed{"transformed", 1}, set_up{"set_up", 3};
  BlockFifo<FragmentBlock> rasterized{"rasterized", 2}, interpolated{"interpolated", 1}, textured{"textured", 2}, turned{"turned", 4},
      lit{"lit", 1}, coloured{"coloured", 2};
  VertexProcessor vertices{context, {}};
  TriangleSetup setup{context, {}};
  Interpolators interpolators{context};
  TextureFetch texture{context, {}};
  EnvironmentUnit environment{context};
  IlluminationUnit illumination{context};
  ColourUnit colour{context, {}};
  FrameSink sink{context};
  std::int64_t blocks = 0, last_blocks = 0, texture_records = 0, progress = 0;

  explicit Plane(std::shared_ptr<const PipelineContext> c) : context(std::move(c)) {}

  void run(std::function<void(std::int64_t)> on_progress = {}) {
    VertexProcessorModule vertex_module("vertex_processor", failure, vertices, transformed, std::move(on_progress));
    TriangleSetupModule setup_module("triangle_setup", failure, setup, transformed, set_up);
    RasterizerModule rasterizer("rasterizer", failure, context, {}, pool, set_up, rasterized);
    FragmentModule<Interpolators> interpolators_module("interpolators", failure, interpolators, rasterized, interpolated);
    FragmentModule<TextureFetch> texture_module("texture_fetch", failure, texture, interpolated, textured);
    FragmentModule<EnvironmentUnit> environment_module("environment", failure, environment, textured, turned);
    FragmentModule<IlluminationUnit> illumination_module("illumination", failure, illumination, turned, lit);
    FragmentModule<ColourUnit> colour_module("colour", failure, colour, lit, coloured);
    FrameSinkModule sink_module("frame_sink", failure, sink, pool, coloured, [this](const FragmentBlock& block) {
      ++blocks;
      last_blocks += block.last;
      texture_records += static_cast<std::int64_t>(block.texture_records.size());
    });
    sc_core::sc_start();
    generated = rasterizer.unit().counters();
  }
  GeometryCounters generated;
};

TEST_CASE("the modules draw the frame that the behaviours draw in a row, and every fragment arrives") {
  const Scene scene = samples::crowded_scene(160, 120);
  const auto context = samples::context(scene);
  Plane plane(context);
  plane.run([&](std::int64_t triangles) { plane.progress = triangles; });
  CHECK_NOTHROW(plane.failure.rethrow());

  samples::Geometry geometry = samples::rasterize(context);
  Interpolators interpolators(context);
  TextureFetch texture(context, {});
  EnvironmentUnit environment(context);
  IlluminationUnit illumination(context);
  ColourUnit colour(context, {});
  FrameSink sink(context);
  for (const auto& block : geometry.blocks) {
    interpolators.process(*block);
    texture.process(*block);
    environment.process(*block);
    illumination.process(*block);
    colour.process(*block);
    sink.process(*block);
  }
  CHECK(plane.sink.hardware().colour == sink.hardware().colour);
  CHECK(plane.sink.exact().colour == sink.exact().colour);
  CHECK(plane.sink.hardware().object == sink.hardware().object);
  CHECK(plane.sink.hardware().depth == sink.hardware().depth);
  CHECK(plane.sink.hardware().colour != plane.sink.exact().colour);

  CHECK(plane.blocks == static_cast<std::int64_t>(geometry.blocks.size()));
  CHECK(plane.last_blocks == 1);
  CHECK(plane.progress == context->triangles());
  CHECK(plane.sink.retired() == plane.generated.fragments);
  CHECK(plane.texture_records == plane.generated.fragments);
  CHECK(plane.generated.fragments_hidden + plane.generated.fragments == plane.generated.fragments_generated);
  CHECK(plane.sink.hidden() == 0);
}

TEST_CASE("an error in a unit's thread keeps its kind and stops the simulation") {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  Plane plane(context);
  plane.run([](std::int64_t triangles) {
    if (triangles > 100) throw Error(ErrorKind::self_check, {"enough", {}, "", ""});
  });
  try {
    plane.failure.rethrow();
    FAIL("nothing was thrown");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::self_check);
  }
}

TEST_CASE("with early z off the frame sink hides what early z would have hidden") {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  RasterizerConfig late;
  late.early_z = false;
  FrameSink early_sink(context), late_sink(context);
  const samples::Geometry early_geometry = samples::rasterize(context), late_geometry = samples::rasterize(context, late);
  for (const auto& block : early_geometry.blocks) early_sink.process(*block);
  for (const auto& block : late_geometry.blocks) late_sink.process(*block);
  CHECK(late_sink.hidden() == early_geometry.raster.fragments_hidden);
  CHECK(late_sink.hardware().depth == early_sink.hardware().depth);
  CHECK(late_sink.hardware().object == early_sink.hardware().object);
}

TEST_CASE("an empty scene leaves one last, empty block and the background") {
  Scene scene = samples::scene({});
  scene.background = {0.1, 0.2, 0.3};
  const auto context = samples::context(scene);
  const samples::Geometry geometry = samples::rasterize(context);
  REQUIRE(geometry.blocks.size() == 1);
  CHECK(geometry.blocks[0]->last);
  CHECK(geometry.blocks[0]->lanes == 0);
  FrameSink sink(context);
  sink.process(*geometry.blocks[0]);
  CHECK(sink.retired() == 0);
  CHECK(sink.hardware().colour[4] == 0.2);
  CHECK(sink.hardware().object[0] == -1);
}

}  // namespace
}  // namespace bump
