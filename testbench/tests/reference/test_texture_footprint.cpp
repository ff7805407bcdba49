// The mip levels that the reference reads, on textures that are not square, where the right level is known.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "shapes.h"
#include "testbench/reference/reference_renderer.h"
#include "testbench/reference/texture_footprint.h"

using namespace bump;

namespace {

/// Noise at level 0, means above it.
std::shared_ptr<Texture> noise(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  auto result = shapes::texture(width, height, channels, [&](int, int, double* texel) {
    for (int c = 0; c < channels; ++c) texel[c] = static_cast<double>(random() % 256) / 255;
  });
  build_mip_levels(*result);
  return result;
}

/// Every texel of level l holds `value(l)` in all three channels.
std::shared_ptr<Texture> marked_levels(int width, int height, const std::function<glm::dvec3(double)>& value) {
  auto result = noise(width, height, 3, 1);
  for (std::size_t l = 0; l < result->levels.size(); ++l) {
    const glm::dvec3 mark = value(static_cast<double>(l));
    for (std::size_t i = 0; i < result->levels[l].texels.size(); ++i) result->levels[l].texels[i] = mark[static_cast<int>(i % 3)];
  }
  return result;
}

/// A plane straight before the camera, with `texels` of a width x height texture from each pixel to the next, along u and along v.
Scene mapped_plane(int width, int height, const glm::dvec2& texels) {
  constexpr int size = 16;
  const double visible = 2 * 4 * std::tan(22.5 * shapes::pi / 180);  // the camera is 4 away and sees 45 degrees
  auto mesh = shapes::plane(1, 1.5 * visible);
  for (Vertex& vertex : mesh->vertices)
    vertex.uv = glm::dvec2(vertex.position) / visible * static_cast<double>(size) * texels / glm::dvec2(width, height);
  Scene scene = shapes::scene(mesh, size);
  REQUIRE(scene.camera.field_of_view == 45);
  scene.lights[0].vector = {0, 0, 1};
  return scene;
}

constexpr double decline = 0.02;  // of brightness, from level to level

}  // namespace

TEST_CASE("the reference reads the level where the longer side of the footprint is one texel") {
  struct Case {
    int width, height;
    glm::dvec2 texels;
    double level;
  };
  const auto check = [](const Scene& scene, double expected) {
    const FrameBuffer frame = render_reference(scene, Filter::trilinear, ReferenceNormals::normal_map);
    for (std::size_t pixel = 0; pixel < frame.object.size(); ++pixel) {
      REQUIRE(frame.object[pixel] == 0);
      REQUIRE(frame.colour[3 * pixel] == Approx(expected).margin(1e-9));
    }
  };
  for (const Case& c :
       {Case{256, 16, {0.2, 0.25}, 0}, Case{16, 256, {0.25, 0.2}, 0}, Case{256, 16, {4, 0.25}, 2}, Case{256, 16, {0.2, 4}, 2},
        Case{16, 256, {0.2, 8}, 3}, Case{256, 16, {3, 1}, std::log2(3)}, Case{64, 64, {2, 1}, 1}}) {
    INFO(c.width << " x " << c.height << ", " << c.texels.x << ", " << c.texels.y);
    const double expected = 1 - decline * c.level;
    Scene coloured = mapped_plane(c.width, c.height, c.texels);
    coloured.objects[0].colour = marked_levels(c.width, c.height, [](double level) { return glm::dvec3(1 - decline * level); });
    coloured.objects[0].material = {1, 0, 0, 1};
    check(coloured, expected);
    if (c.level != std::floor(c.level)) continue;  // between levels a mean of normals has another length
    Scene bumped = mapped_plane(c.width, c.height, c.texels);
    bumped.objects[0].normals = marked_levels(c.width, c.height, [](double level) {
      const double z = 1 - decline * level;  // the cosine to the light
      return glm::dvec3(std::sqrt(1 - z * z), 0, z);
    });
    bumped.objects[0].material = {0, 1, 0, 1};
    check(bumped, expected);
  }
}

TEST_CASE("where every texel covers pixels, a trilinear reference is the bilinear one, bit for bit") {
  Scene scene = mapped_plane(256, 16, {0.9, 0.8});
  scene.objects[0].colour = noise(256, 16, 3, 2);
  scene.objects[0].normals = noise(256, 16, 3, 3);
  scene.objects[0].heights = noise(256, 16, 1, 4);
  for (const ReferenceNormals which : {ReferenceNormals::normal_map, ReferenceNormals::blinn}) {
    const FrameBuffer bilinear = render_reference(scene, Filter::bilinear, which);
    CHECK(render_reference(scene, Filter::trilinear, which).colour == bilinear.colour);
    CHECK(*std::min_element(bilinear.colour.begin(), bilinear.colour.end()) <
          *std::max_element(bilinear.colour.begin(), bilinear.colour.end()));
  }
}

TEST_CASE("the level of an access depends on the texture's own size") {
  const PixelFootprint footprint{glm::dvec2(1.0 / 64, 0), glm::dvec2(0, -1.0 / 16)};
  CHECK(reference_level(*noise(256, 16, 1, 1), Filter::trilinear, footprint) == 2);
  CHECK(reference_level(*noise(16, 256, 1, 1), Filter::trilinear, footprint) == 4);
  CHECK(reference_level(*noise(64, 16, 1, 1), Filter::trilinear, footprint) == 0);
  CHECK(reference_level(*noise(256, 16, 1, 1), Filter::bilinear, footprint) == 0);
  CHECK(reference_level(*noise(256, 16, 1, 1), Filter::trilinear, PixelFootprint(0)) == 0);
}
