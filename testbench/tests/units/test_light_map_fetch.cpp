// Light maps: where their words lie, what fills them, and what the fetch unit reads and counts.

#include <catch2/catch.hpp>
#include <set>

#include "light_map_sample.h"
#include "units/colour_unit.h"
#include "units/environment_unit.h"
#include "units/illumination_unit.h"
#include "units/interpolators.h"
#include "units/light_map_fetch.h"
#include "units/light_map_layout.h"
#include "units/texture_fetch.h"

namespace bump {
namespace {

/// All units behind the rasterizer, one block after another.
struct Shading {
  std::shared_ptr<const PipelineContext> context;
  samples::Geometry geometry;
  EnvironmentUnit environment;
  LightMapFetch light_maps;
  IlluminationUnit illumination;
  ColourUnit colour;
  std::int64_t fragments = 0;
  std::vector<std::vector<DistantLight>> lights_;  ///< by object

  explicit Shading(std::shared_ptr<const PipelineContext> c, const LightMapFetchConfig& config = {})
      : context(std::move(c)),
        geometry(samples::rasterize(context)),
        environment(context),
        light_maps(context, config),
        illumination(context),
        colour(context, {}) {
    Interpolators interpolators(context);
    TextureFetch texture(context, {});
    for (const auto& block : geometry.blocks) {
      interpolators.process(*block);
      texture.process(*block);
      environment.process(*block);
      light_maps.process(*block);
      illumination.process(*block);
      colour.process(*block);
      fragments += block->lanes;
    }
    for (std::size_t i = 0; i < context->spaces.size(); ++i)
      lights_.push_back(distant_lights(context->spaces[i], *context->scene->objects[i].mesh));
  }
  double hardware(const FragmentBlock& block, const std::string& plane, std::size_t lane) const {
    return block.hardware[static_cast<std::size_t>(context->planes.index(plane))][lane];
  }
  double exact(const FragmentBlock& block, const std::string& plane, std::size_t lane) const {
    return context->exact_plane(block, context->planes.index(plane))[lane];
  }
  const std::vector<DistantLight>& lights(int object) const { return lights_[static_cast<std::size_t>(object)]; }
  /// Calls `check(block, lane)` for every fragment.
  template <class Check>
  void each(const Check& check) const {
    for (const auto& block : geometry.blocks)
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) check(*block, lane);
  }
};

LightMaps maps_of_words(std::vector<int> widths, int address_bits, int column_bits) {
  LightMaps maps;
  for (std::size_t i = 0; i < widths.size(); ++i) maps.maps.push_back({std::to_string(i), ufixed(widths[i], 0)});
  maps.address_bits = address_bits;
  maps.column_bits = column_bits;
  return maps;
}

}  // namespace

TEST_CASE("every word of every light map has an address of its own, and a tile of rows and columns fills a line") {
  for (const int line : {4, 8, 64, 128, 4096})
    for (const auto& [address_bits, column_bits] : {std::pair{8, 0}, std::pair{9, 3}, std::pair{6, 6}, std::pair{7, 1}}) {
      CAPTURE(line, address_bits, column_bits);
      const LightMapLayout layout(maps_of_words({8, 12, 1, 17}, address_bits, column_bits), line);
      CHECK(layout.word_bytes(0) == 1);
      CHECK(layout.word_bytes(1) == 2);
      CHECK(layout.word_bytes(2) == 1);
      CHECK(layout.word_bytes(3) == 4);
      std::set<std::uint64_t> bytes;
      std::size_t words = 0;
      std::set<std::pair<int, std::uint64_t>> lines[4];
      for (int object = 0; object < 3; ++object)
        for (int map = 0; map < 4; ++map)
          for (std::int64_t entry = 0; entry < (std::int64_t{1} << address_bits); ++entry) {
            const std::uint64_t address = layout.address(object, map, entry);
            for (int byte = 0; byte < layout.word_bytes(map); ++byte) bytes.insert(address + static_cast<std::uint64_t>(byte));
            words += static_cast<std::size_t>(layout.word_bytes(map));
            lines[map].insert({object, address / static_cast<std::uint64_t>(line)});
          }
      CHECK(bytes.size() == words);
      // No two maps share a line, and none takes more lines than its bytes.
      std::set<std::uint64_t> all;
      std::size_t sum = 0;
      for (int map = 0; map < 4; ++map) {
        const std::size_t map_bytes = (std::size_t{1} << address_bits) * static_cast<std::size_t>(layout.word_bytes(map));
        CHECK(lines[map].size() == 3 * ((map_bytes + static_cast<std::size_t>(line) - 1) / static_cast<std::size_t>(line)));
        for (const auto& [object, index] : lines[map]) all.insert(index);
        sum += lines[map].size();
      }
      CHECK(all.size() == sum);
    }
  const LightMapLayout square(maps_of_words({8, 8}, 20, 0), 64);
  for (const std::int64_t corner : {0L, 8L, 8L << 10, (1L << 20) - (8L << 10) + 1016}) {
    const std::uint64_t line = square.address(1, 1, corner) / 64;
    for (std::int64_t row = 0; row < 8; ++row)
      for (std::int64_t column = 0; column < 8; ++column) CHECK(square.address(1, 1, corner + (row << 10) + column) / 64 == line);
  }
  CHECK(square.address(0, 1, 0) == 1u << 20);
  CHECK(square.address(1, 0, 0) == 2u << 20);
}

TEST_CASE("lights and eye are seen from the centre of the object's box, in the axes of the vertex program") {
  auto mesh = std::make_shared<Mesh>(*samples::sphere(6));
  for (Vertex& vertex : mesh->vertices) vertex.position += glm::dvec3(5, 0, 0);
  Scene scene = samples::light_map_scene();
  const glm::dmat4 placed =
      glm::scale(glm::rotate(glm::translate(glm::dmat4(1), {1.0, 2.0, -3.0}), 0.7, glm::dvec3(0, 1, 0)), glm::dvec3(0.5));
  scene.objects = {samples::object(mesh, placed)};
  for (const ShadingSpace shading : {ShadingSpace::object, ShadingSpace::eye}) {
    const ObjectSpace space = make_object_space(scene, scene.objects[0], glm::dmat4(1), shading);
    const std::vector<DistantLight> lights = distant_lights(space, *mesh);
    REQUIRE(lights.size() == 3);
    const glm::dvec3 centre = glm::dvec3(placed * glm::dvec4(5, 0, 0, 1)), eye = glm::normalize(scene.camera.eye - centre);
    for (std::size_t l = 0; l < 3; ++l) {
      const Light& light = scene.lights[l];
      const glm::dvec3 towards = light.directional ? light.vector : glm::normalize(light.vector - centre);
      // Turned into the world, whatever the axes: angles between the vectors and to the eye are the same.
      CHECK(glm::dot(lights[l].light, glm::normalize(space.eye_vector({5, 0, 0}))) == Approx(glm::dot(towards, eye)));
      CHECK(glm::length(lights[l].light) == Approx(1));
      CHECK(glm::dot(lights[l].half, lights[l].light) == Approx(glm::dot(glm::normalize(towards + eye), towards)));
      CHECK(lights[l].intensity == light.intensity);
    }
  }
  // A light in the centre, and one right behind the object, have no direction rather than one that is not a number.
  scene.objects = {samples::object(samples::plane(2))};
  scene.lights = {{false, {0, 0, 0}, 1}, {true, -glm::normalize(scene.camera.eye), 1}};
  const std::vector<DistantLight> lights =
      distant_lights(make_object_space(scene, scene.objects[0], glm::dmat4(1)), *scene.objects[0].mesh);
  CHECK(glm::length(lights[0].light) == 0);
  CHECK(glm::length(lights[1].half) == 0);
}

TEST_CASE("the maps hold the rounded sum over the lights of the fill formula at the centre of each entry") {
  const std::vector<DistantLight> lights = {{{0, 0, 1}, glm::normalize(glm::dvec3(0, 1, 4)), 1},
                                            {glm::normalize(glm::dvec3(1, 1, 1)), {0, 0, 1}, 2.5}};
  const Format word = ufixed(9, 8);  // holds less than 2: bright entries are cut off
  const LightMaps maps = samples::light_maps(5, word);
  LightMapFill fill(maps);
  fill.set_lights(lights);
  LightMapWords filled;
  fill.fill(filled);
  REQUIRE(filled.words.size() == 2);
  REQUIRE(filled.words[0].size() == 1024);
  int clipped = 0;
  for (std::int64_t entry = 0; entry < 1024; ++entry) {
    const glm::dvec3 normal =
        samples::light_map_normal((static_cast<double>(entry % 32) + 0.5) / 16, (static_cast<double>(entry / 32) + 0.5) / 16);
    const auto [diffuse, specular] = samples::light_map_formula(normal, lights);
    const auto at = static_cast<std::size_t>(entry);
    CAPTURE(entry, diffuse, specular);
    REQUIRE(filled.words[0][at] == quantise(diffuse, word));
    REQUIRE(filled.words[1][at] == quantise(specular, word));
    REQUIRE(filled.clipped[0][at] == (diffuse >= word.highest() + word.step() / 2));
    REQUIRE_FALSE(filled.clipped[1][at]);
    clipped += filled.clipped[0][at] ? 1 : 0;
  }
  CHECK(clipped > 0);
  CHECK(clipped < 1024);

  fill.set_lights({});
  fill.fill(filled);
  CHECK(std::all_of(filled.words[0].begin(), filled.words[0].end(), [](std::int32_t w) { return w == 0; }));
}

TEST_CASE("a fragment fetches the word nearest to its normal, in the maps of its object, for all lights at once") {
  const Scene scene = samples::light_map_scene();
  const Format word = ufixed(18, 16);
  const Shading s(samples::light_map_context(scene));
  std::set<int> objects_seen;
  s.each([&](const FragmentBlock& block, std::size_t lane) {
    objects_seen.insert(block.object);
    const auto entry = static_cast<std::int64_t>(s.hardware(block, "light_map.entry", lane)) - (std::int64_t{block.object} << 20);
    const double column = s.hardware(block, "m.s", lane) * 512, row = s.hardware(block, "m.t", lane) * 512;
    REQUIRE(entry == (static_cast<std::int64_t>(row) << 10) + static_cast<std::int64_t>(column));
    const glm::dvec3 normal = samples::light_map_normal((std::floor(column) + 0.5) / 512, (std::floor(row) + 0.5) / 512);
    const auto [diffuse, specular] = samples::light_map_formula(normal, s.lights(block.object));
    REQUIRE(s.hardware(block, "light.diffuse", lane) == to_double(quantise(diffuse, word), word));
    REQUIRE(s.hardware(block, "light.specular", lane) == to_double(quantise(specular, word), word));
  });
  CHECK(objects_seen.size() == 2);
  CHECK(s.light_maps.executions() == s.fragments);
  CHECK(s.environment.executions() == s.fragments);
  CHECK(s.illumination.executions() == s.fragments);
  CHECK(s.light_maps.words_written() == 2 << 20);
  CHECK(s.light_maps.fill_executions() == 2 << 20);
}

TEST_CASE("the double evaluation takes the continuous function, and fine maps come close to it") {
  const Scene scene = samples::light_map_scene();
  const Shading s(samples::light_map_context(scene));
  double worst = 0;
  s.each([&](const FragmentBlock& block, std::size_t lane) {
    const double x = s.exact(block, "n.x", lane), y = s.exact(block, "n.y", lane);
    const auto [diffuse, specular] = samples::light_map_formula(samples::light_map_normal(x + 1, y + 1), s.lights(block.object));
    REQUIRE(s.exact(block, "light.diffuse", lane) == Approx(diffuse).margin(1e-12));
    REQUIRE(s.exact(block, "intensity", lane) == Approx(diffuse + specular).margin(1e-12));
    double colour = scene.objects[0].material.ambient + diffuse + specular;
    colour = std::clamp(colour * s.exact(block, "tex.g", lane), 0.0, 1.0);
    REQUIRE(s.exact(block, "colour.g", lane) == Approx(colour).margin(1e-12));
    // At the rim of the half sphere z falls steeply with x and y: entries there are coarse.
    if (x * x + y * y < 0.9) worst = std::max(worst, std::fabs(s.hardware(block, "colour.g", lane) - colour));
  });
  CHECK(worst < 0.01);
  CHECK(worst > 0);
}

TEST_CASE("every look-up is a hit or a miss of one cache over all maps, and a record says how many lines a fragment asks for") {
  const Scene scene = samples::light_map_scene();
  for (const int ways : {1, 4}) {
    LightMapFetchConfig config;
    config.cache = {4, ways, 32};
    config.reads_per_cycle = 1;
    const Shading s(samples::light_map_context(scene, {}, 8), config);
    const LightMapLayout layout(*s.context->designs[0].light_maps, 32);
    TextureCache cache(config.cache);
    LightMapCounters expected[2];
    std::int64_t recorded = 0;
    s.each([&](const FragmentBlock& block, std::size_t lane) {
      const auto entry = static_cast<std::int64_t>(s.hardware(block, "light_map.entry", lane)) - (std::int64_t{block.object} << 16);
      int misses = 0;
      for (int map = 0; map < 2; ++map) {
        const bool hit = cache.access(layout.address(block.object, map, entry));
        ++(hit ? expected[map].hits : expected[map].misses);
        misses += hit ? 0 : 1;
      }
      REQUIRE(block.light_map_records.size() == static_cast<std::size_t>(block.lanes));
      REQUIRE(block.light_map_records[lane].misses == misses);
      REQUIRE(block.light_map_records[lane].interval == 2);
      recorded += misses;
    });
    for (std::size_t map = 0; map < 2; ++map) {
      const LightMapCounters& counted = s.light_maps.counters()[map];
      CHECK(counted.reads == s.fragments);
      CHECK(counted.hits == expected[map].hits);
      CHECK(counted.misses == expected[map].misses);
      CHECK(counted.hits + counted.misses == counted.reads);
      CHECK(counted.bytes == 32 * counted.misses);
      CHECK(counted.misses > 0);
      CHECK(counted.clipped == 0);
    }
    CHECK(recorded == expected[0].misses + expected[1].misses);
  }
}

TEST_CASE("runs in double precision address as the hardware does and take the continuous function") {
  const Scene scene = samples::light_map_scene();
  ContextOptions options;
  const Shading fixed(samples::light_map_context(scene, options, 7));
  options.arithmetic = Arithmetic::real;
  const Shading real_run(samples::light_map_context(scene, options, 7));
  for (std::size_t map = 0; map < 2; ++map) {
    CHECK(real_run.light_maps.counters()[map].hits == fixed.light_maps.counters()[map].hits);
    CHECK(real_run.light_maps.counters()[map].misses == fixed.light_maps.counters()[map].misses);
  }
  REQUIRE(real_run.geometry.blocks.size() == fixed.geometry.blocks.size());
  for (std::size_t b = 0; b < fixed.geometry.blocks.size(); ++b)
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(fixed.geometry.blocks[b]->lanes); ++lane)
      REQUIRE(real_run.hardware(*real_run.geometry.blocks[b], "colour.r", lane) ==
              fixed.exact(*fixed.geometry.blocks[b], "colour.r", lane));
}

TEST_CASE("fragments that read a word that was cut off are counted and left out of the stated bound") {
  Scene scene = samples::light_map_scene();
  scene.lights[0].intensity = 3;
  const Shading s(samples::light_map_context(scene, {}, 8, ufixed(8, 8)));
  std::int64_t clipped = 0;
  s.each([&](const FragmentBlock& block, std::size_t lane) {
    const bool full = s.hardware(block, "light.diffuse", lane) == 255.0 / 256;
    if (block.diverged[lane] != 0) {
      ++clipped;
      REQUIRE(full);
    } else if (full) {
      REQUIRE(s.exact(block, "light.diffuse", lane) == Approx(255.0 / 256).margin(0.1));  // rounded, not cut off
    }
  });
  CHECK(clipped > 0);
  CHECK(s.light_maps.counters()[0].clipped == clipped);
}

TEST_CASE("the colour unit takes the sum of the lights as it comes from light maps") {
  const Scene scene = samples::light_map_scene();
  const Netlist colour = colour_netlist(scene, scene.objects[0].material, {}, LightSum::in_light_maps);
  CHECK(count(colour).multipliers == 3);
  CHECK(count(colour).adders == 1);
  CHECK(colour.inputs().front().name == "intensity");
}

TEST_CASE("light maps that do not fit are refused") {
  const auto refusal = [](const auto& act) {
    try {
      act();
    } catch (const Error& error) {
      return std::pair{error.kind(), std::string(error.what())};
    }
    return std::pair{ErrorKind::cancelled, std::string("accepted")};
  };
  const auto context_of = [](const Scene& scene, Design design) {
    std::vector<Design> designs;
    designs.push_back(std::move(design));
    return make_context(scene, std::move(designs), std::vector<int>(scene.objects.size(), 0), {});
  };
  const Scene scene = samples::light_map_scene();
  Design per_light = samples::light_map_design();
  per_light.vertex.output("l.x", per_light.vertex.input("L.x", real()));
  per_light.interpolants.push_back({"l.x", InterpolantKind::linear});
  const auto light = refusal([&] { context_of(scene, std::move(per_light)); });
  CHECK(light.first == ErrorKind::internal);
  CHECK_THAT(light.second, Catch::Contains("l.x") && Catch::Contains("sum of all lights"));

  Design no_base = samples::light_map_design();
  no_base.light_maps->address = Netlist("address");
  CHECK_THAT(refusal([&] { context_of(scene, std::move(no_base)); }).second, Catch::Contains("light_map.base"));
  Design wide = samples::light_map_design();
  wide.light_maps->maps[1].word = ufixed(32, 16);
  CHECK_THAT(refusal([&] { context_of(scene, std::move(wide)); }).second, Catch::Contains("specular"));
  Design unfilled = samples::light_map_design();
  unfilled.light_maps->fill = Netlist("frame");
  CHECK_THAT(refusal([&] { LightMapFetch(context_of(scene, std::move(unfilled)), {}); }).second, Catch::Contains("no output 'diffuse'"));

  Scene crowd = scene;
  while (crowd.objects.size() < 9) crowd.objects.push_back(crowd.objects[0]);
  const auto crowded = refusal([&] { LightMapFetch(samples::light_map_context(crowd), {}); });
  CHECK(crowded.first == ErrorKind::input);
  CHECK_THAT(crowded.second, Catch::Contains("9 objects") && Catch::Contains("8 apart"));
  LightMapFetchConfig narrow;
  narrow.cache.line_bytes = 2;
  CHECK_THAT(refusal([&] { LightMapFetch(samples::light_map_context(scene), narrow); }).second, Catch::Contains("line_bytes at least 4"));

  Parameters parameters;
  LightMapFetchConfig::declare(parameters);
  Configuration configuration(parameters);
  CHECK(LightMapFetchConfig(configuration).cache == LightMapFetchConfig().cache);
  CHECK(LightMapFetchConfig(configuration).reads_per_cycle == LightMapFetchConfig().reads_per_cycle);
  configuration.set_text("light_map_fetch.cache.sets", "3", {"test", 0, 0});
  CHECK_THAT(refusal([&] { LightMapFetchConfig{configuration}; }).second, Catch::Contains("light-map cache of 3 sets"));
}

}  // namespace bump
