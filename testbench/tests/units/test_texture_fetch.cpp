// The texture unit: texels as the filter says, and every line, hit, miss and footprint accounted for.

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <set>

#include "memory/level_of_detail.h"
#include "samples.h"
#include "units/bump_map.h"
#include "units/texture_fetch.h"

namespace bump {
namespace {

TEST_CASE("every texel has an address of its own, a tile of four-byte texels is a line, and levels start on lines") {
  const auto texture = samples::texture(21, 10, 3, 1);
  const TextureLayout layout(*texture, 100, 64);
  std::set<std::uint64_t> seen;
  for (int l = 0; l < static_cast<int>(texture->levels.size()); ++l) {
    const TextureLevel& level = texture->levels[static_cast<std::size_t>(l)];
    CHECK(layout.address(l, 0, 0) % 64 == 0);
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) {
        const std::uint64_t address = layout.address(l, x, y);
        REQUIRE((address >= 100 && address + 4 <= layout.end()));
        REQUIRE(seen.insert(address).second);
        REQUIRE(address / 64 == layout.address(l, x / 4 * 4, y / 4 * 4) / 64);
      }
    }
  }
}

TEST_CASE("a bump map holds each level's own normals, encoded, and rounds them to the channels' formats") {
  const auto normals = samples::normals(16, 8, 5);
  Design design = samples::design();
  const Texture map = encode_bump_map(*normals, design.map);
  const Texture stored = quantise_texels(map, design.map);
  REQUIRE(map.levels.size() == normals->levels.size());
  CHECK(map.bytes_per_texel == 4);  // 3 x 10 bits
  double largest = 0;
  for (std::size_t l = 0; l < map.levels.size(); ++l) {
    for (std::size_t i = 0; i < map.levels[l].texels.size(); i += 3) {
      const double* n = &normals->levels[l].texels[i];
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t c = 0; c < 3; ++c) {
        REQUIRE(map.levels[l].texels[i + c] == Approx(n[c] / length));
        const double word = stored.levels[l].texels[i + c] * 256;
        REQUIRE(word == std::floor(word));
        largest = std::max(largest, std::fabs(stored.levels[l].texels[i + c] - map.levels[l].texels[i + c]));
      }
    }
  }
  CHECK(largest <= 0.5 / 256);
  CHECK(largest > 0.4 / 256);
  design.map.channels[0].format = sfixed(13, 11);
  CHECK(bytes_per_texel(design.map) == 8);
  design.map.channels.resize(1);
  CHECK(bytes_per_texel(design.map) == 2);
}

/// Runs the texture unit over a scene with the given filter and compares every fragment with sample() and a replay of the cache.
void compare(Filter filter, int footprints_per_cycle, const CacheGeometry& geometry_of_cache) {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  const samples::Geometry geometry = samples::rasterize(context);
  TextureFetchConfig config;
  config.filter = filter;
  config.footprints_per_cycle = footprints_per_cycle;
  config.cache = geometry_of_cache;
  const int line_bytes = config.cache.line_bytes;
  TextureFetch unit(context, config);
  TextureCache cache(config.cache);
  const Design design = samples::design();
  // Placement in memory: colour and map of each object in turn.
  std::vector<Texture> colours, maps, exact_maps;
  std::vector<TextureLayout> colour_layouts, map_layouts;
  std::uint64_t end = 0;
  for (const SceneObject& object : scene.objects) {
    colours.push_back(*object.colour);
    exact_maps.push_back(encode_bump_map(*object.normals, design.map));
    maps.push_back(quantise_texels(exact_maps.back(), design.map));
    colour_layouts.emplace_back(colours.back(), end, line_bytes);
    map_layouts.emplace_back(maps.back(), colour_layouts.back().end(), line_bytes);
    end = map_layouts.back().end();
  }
  TextureCounters expected;
  for (const auto& block : geometry.blocks) {
    unit.process(*block);
    REQUIRE(block->texture_records.size() == static_cast<std::size_t>(block->lanes));
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      const auto object = static_cast<std::size_t>(block->object);
      std::vector<std::uint64_t> lines;
      unsigned footprints = 0, misses = 0;
      const auto access = [&](const Texture& texture, const TextureLayout& layout, double lod) {
        TexelTap taps[8];
        const int count = texel_taps(texture, filter, block->u[lane], block->v[lane], lod, taps);
        expected.reads += count;
        footprints += count > 4 ? 2 : 1;
        for (int i = 0; i < count; ++i) {
          const std::uint64_t address = layout.address(taps[i].level, taps[i].x, taps[i].y);
          const std::uint64_t line = address / static_cast<std::uint64_t>(line_bytes);
          if (std::count(lines.begin(), lines.end(), line)) continue;
          lines.push_back(line);
          const bool hit = cache.access(address);
          ++expected.accesses;
          ++(hit ? expected.hits : expected.misses);
          misses += hit ? 0 : 1;
        }
      };
      // Both textures are 32 x 32.
      const double lod =
          lod_of_access(colours[object], filter, {block->dudx[lane], block->dvdx[lane], block->dudy[lane], block->dvdy[lane]});
      access(colours[object], colour_layouts[object], lod);
      access(maps[object], map_layouts[object], lod);
      const TokenRecord& record = block->texture_records[lane];
      REQUIRE(record.interval ==
              (footprints + static_cast<unsigned>(footprints_per_cycle) - 1) / static_cast<unsigned>(footprints_per_cycle));
      REQUIRE(record.misses == misses);
      double texel[3];
      const char* axes[3] = {"x", "y", "z"};
      const char* channels[3] = {"r", "g", "b"};
      const auto check = [&](const Texture& texture, const std::vector<Lanes>& planes, const std::string& prefix,
                             const char* const* names) {
        sample(texture, filter, block->u[lane], block->v[lane], lod, texel);
        for (int c = 0; c < 3; ++c) REQUIRE(planes[static_cast<std::size_t>(context->planes.index(prefix + names[c]))][lane] == texel[c]);
      };
      check(colours[object], block->hardware, "tex.", channels);
      check(maps[object], block->hardware, "map.", axes);
      check(exact_maps[object], block->exact, "map.", axes);
    }
  }
  CHECK(unit.counters().reads == expected.reads);
  CHECK(unit.counters().accesses == expected.accesses);
  CHECK(unit.counters().hits == expected.hits);
  CHECK(unit.counters().misses == expected.misses);
  CHECK(unit.counters().bytes == line_bytes * expected.misses);
  CHECK(expected.misses > 0);
  // A single line, or less than a fragment reads, may be lost before it is asked for again.
  if (config.cache.sets * config.cache.ways >= 8) CHECK(expected.hits > 0);
}

// Caches that hold all lines of a fragment, and some that lose one before the next fragment asks for it.
TEST_CASE("texels, lines, hits and intervals are those of a replay, nearest") {
  for (const CacheGeometry& cache : {CacheGeometry{4, 2, 64}, {1, 1, 64}, {2, 3, 16}}) compare(Filter::nearest, 2, cache);
}
TEST_CASE("texels, lines, hits and intervals are those of a replay, bilinear") {
  for (const CacheGeometry& cache : {CacheGeometry{4, 2, 64}, {1, 1, 256}, {2, 3, 16}, {1, 4, 64}, {1, 7, 4}, {32, 4, 64}})
    compare(Filter::bilinear, 1, cache);
}
TEST_CASE("texels, lines, hits and intervals are those of a replay, trilinear") {
  for (const CacheGeometry& cache : {CacheGeometry{4, 2, 64}, {1, 4, 32}, {1, 12, 16}, {8, 1, 64}}) compare(Filter::trilinear, 3, cache);
}

/// A texture whose texels of level l are all `value(l)`.
std::shared_ptr<Texture> marked_levels(int width, int height, const std::function<glm::dvec3(double)>& value) {
  auto result = samples::texture(width, height, 3, 1);
  for (std::size_t l = 0; l < result->levels.size(); ++l) {
    const glm::dvec3 mark = value(static_cast<double>(l));
    for (std::size_t i = 0; i < result->levels[l].texels.size(); ++i) result->levels[l].texels[i] = mark[static_cast<int>(i % 3)];
  }
  return result;
}

TEST_CASE("each texture is read at the level where the longer side of the footprint is one of its own texels") {
  struct Case {
    glm::ivec2 colour;
    glm::dvec2 texels;  // of the colour texture, from pixel to pixel along u and v
    double colour_level;
    glm::ivec2 map;
    double map_level;
  };
  const Case cases[] = {{{256, 16}, {0.2, 0.25}, 0, {256, 16}, 0}, {{16, 256}, {0.25, 0.2}, 0, {32, 512}, 0},
                        {{256, 16}, {4, 0.25}, 2, {64, 64}, 0},    {{256, 16}, {0.25, 4}, 2, {256, 64}, 4},
                        {{16, 256}, {0.2, 8}, 3, {32, 64}, 1},     {{64, 64}, {2, 1}, 1, {32, 256}, 2}};
  for (const Case& c : cases) {
    INFO(c.colour.x << " x " << c.colour.y << ", " << c.texels.x << ", " << c.texels.y);
    SceneObject object;
    auto mesh = samples::plane(1);
    Scene scene = samples::scene({});
    // Pixels of a length of 1 in the plane z = 0.
    const double pixels = 0.5 * scene.height / std::tan(scene.camera.field_of_view * 3.14159265358979323846 / 360) / scene.camera.eye.z;
    for (Vertex& vertex : mesh->vertices) vertex.uv = glm::dvec2(vertex.position) * pixels * c.texels / glm::dvec2(c.colour);
    object.mesh = mesh;
    object.colour = marked_levels(c.colour.x, c.colour.y, [](double level) { return glm::dvec3(level / 16); });
    const auto tilted = [](double level) { return glm::dvec3(std::sin(level / 16), 0, std::cos(level / 16)); };
    object.normals = marked_levels(c.map.x, c.map.y, tilted);
    scene.objects.push_back(object);
    const auto context = samples::context(scene);
    RasterizerConfig rasterizer;
    TriangleSetupConfig setup;
    rasterizer.subpixel_bits = setup.subpixel_bits = 12;
    const samples::Geometry geometry = samples::rasterize(context, rasterizer, setup);
    TextureFetchConfig config;
    config.filter = Filter::trilinear;
    TextureFetch unit(context, config);
    const auto colour = static_cast<std::size_t>(context->planes.index("tex.r")),
               map = static_cast<std::size_t>(context->planes.index("map.x"));
    int fragments = 0;
    for (const auto& block : geometry.blocks) {
      unit.process(*block);
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane, ++fragments) {
        // Derivatives are those of a plane snapped to the subpixel grid.
        REQUIRE(block->dudx[lane] * c.colour.x == Approx(c.texels.x).epsilon(1e-4));
        REQUIRE(block->dvdy[lane] * c.colour.y == Approx(-c.texels.y).epsilon(1e-4));
        REQUIRE(block->hardware[colour][lane] * 16 == Approx(c.colour_level).margin(1e-3));
        REQUIRE(std::asin(block->exact[map][lane]) * 16 == Approx(c.map_level).margin(1e-3));
      }
    }
    CHECK(fragments > 500);
    // On a whole level the filter reads one footprint, up to the rounding above.
    if (c.colour_level == 0 && c.map_level == 0) CHECK(unit.counters().reads == 8 * fragments);
  }
}

TEST_CASE("a bump map that must not be filtered is read one texel at a time") {
  const Scene scene = samples::scene({samples::object(samples::plane(1))});
  std::vector<Design> designs;
  designs.push_back(samples::design());
  designs[0].map.filterable = false;
  const auto context = make_context(scene, std::move(designs), {0}, {});
  const samples::Geometry geometry = samples::rasterize(context);
  TextureFetch unit(context, {});
  for (const auto& block : geometry.blocks) unit.process(*block);
  CHECK(unit.counters().reads == 5 * geometry.raster.fragments);
}

/// A map whose slopes are its texture coordinates, over all repeats; counts the maps made.
Design baked_design(int& maps) {
  Design design = samples::design();
  design.map.bake = [&maps](const SceneObject& object) {
    ++maps;
    const auto slopes = [](const SurfaceTexel& at) { return glm::normalize(glm::dvec3(at.uv, 1)); };
    return bake_surface_map(object, *object.normals, slopes, "another map");
  };
  return design;
}

TEST_CASE("a map of one surface is read where it was made for, over all repeats of the texture") {
  for (const Filter filter : {Filter::bilinear, Filter::trilinear}) {
    int maps = 0;
    auto mesh = samples::plane(3);
    for (Vertex& vertex : mesh->vertices) vertex.uv = vertex.uv * glm::dvec2(3, -1) + glm::dvec2(2, 0);
    const Scene scene = samples::scene({samples::object(mesh)});
    std::vector<Design> designs;
    designs.push_back(baked_design(maps));
    const auto context = make_context(scene, std::move(designs), {0}, {});
    const samples::Geometry geometry = samples::rasterize(context);
    TextureFetchConfig config;
    config.filter = filter;
    TextureFetch unit(context, config);
    const auto map = static_cast<std::size_t>(context->planes.index("map.x"));
    int fragments = 0;
    for (const auto& block : geometry.blocks) {
      unit.process(*block);
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
        const double u = block->u[lane], v = block->v[lane];
        if (u < 2.1 || u > 4.9 || v > -0.1 || v < -0.9) continue;  // at the border the filter reads the other side
        ++fragments;
        REQUIRE(block->exact[map][lane] / block->exact[map + 2][lane] == Approx(u).epsilon(2e-3));
        REQUIRE(block->exact[map + 1][lane] / block->exact[map + 2][lane] == Approx(v).epsilon(2e-2));
      }
    }
    CHECK(fragments > 500);
    CHECK(maps == 1);
  }
}

TEST_CASE("objects share a map of their surface only if surface and textures are the same") {
  const SceneObject one = samples::object(samples::plane(2));
  SceneObject two = one, three = one, four = one;
  two.to_world = glm::translate(glm::dmat4(1), {0.1, 0.0, 0.5});
  three.mesh = samples::plane(2);
  four.heights = samples::texture(32, 32, 1, 4);
  const Scene scene = samples::scene({one, two, three, four});
  int maps = 0;
  std::vector<Design> designs;
  designs.push_back(baked_design(maps));
  TextureFetch unit(make_context(scene, std::move(designs), {0, 0, 0, 0}, {}), {});
  CHECK(maps == 3);
}

TEST_CASE("a map in object space is refused where vectors are shaded in another") {
  const Scene scene = samples::scene({samples::object(samples::plane(1))});
  for (const ShadingSpace space : {ShadingSpace::object, ShadingSpace::eye}) {
    int maps = 0;
    std::vector<Design> designs;
    designs.push_back(baked_design(maps));
    designs[0].map.in_object_space = true;
    ContextOptions options;
    options.shading = space;
    const auto context = make_context(scene, std::move(designs), {0}, options);
    if (space == ShadingSpace::object) {
      TextureFetch unit(context, {});
      CHECK(maps == 1);
    } else {
      CHECK_THROWS_WITH(TextureFetch(context, {}), Catch::Contains("object space") && Catch::Contains("vertex_processor.space=object"));
    }
  }
}

TEST_CASE("objects that share a texture share it in memory") {
  SceneObject one = samples::object(samples::plane(1)), two = one;
  two.to_world = glm::translate(glm::dmat4(1), {0.1, 0.0, 0.5});
  const Scene scene = samples::scene({one, two});
  const auto context = samples::context(scene);
  const samples::Geometry geometry = samples::rasterize(context);
  TextureFetchConfig config;
  config.cache = {1024, 4, 64};
  TextureFetch unit(context, config);
  for (const auto& block : geometry.blocks) unit.process(*block);
  // 32 x 32 texels of 4 bytes are 64 lines; all levels of both textures together hold less than 200.
  CHECK(unit.counters().misses < 200);
  CHECK(unit.counters().accesses > 2000);
}

}  // namespace
}  // namespace bump
