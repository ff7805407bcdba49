// The level of detail of the texture unit: each texture's own, by the axis of the pixel's footprint that is longer in its texels.

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "memory/level_of_detail.h"

using namespace bump;

namespace {

Texture sized(int width, int height) {
  Texture texture;
  texture.channels = 1;
  texture.kinds = {ChannelKind::linear};
  texture.levels.push_back({width, height, std::vector<double>(static_cast<std::size_t>(width * height))});
  build_mip_levels(texture);
  return texture;
}

}  // namespace

TEST_CASE("the level of detail is log2 of the longer footprint axis in texels, whatever the texture's shape") {
  for (const auto& [width, height] : {std::pair<int, int>{256, 16}, {16, 256}, {64, 64}, {1, 8}}) {
    const double w = width, h = height;
    CHECK(level_of_detail({0.2 / w, 0, 0, 0.25 / h}, width, height) == Approx(-2));
    CHECK(level_of_detail({0.2 / w, 0, 0, -8 / h}, width, height) == Approx(3));
    CHECK(level_of_detail({-4 / w, 0, 0, 0.25 / h}, width, height) == Approx(2));
    CHECK(level_of_detail({3 / w, 4 / h, 1 / w, 1 / h}, width, height) == Approx(std::log2(5)));
    CHECK(level_of_detail({1 / w, 0, -6 / w, 8 / h}, width, height) == Approx(std::log2(10)));
  }
}

TEST_CASE("a footprint twice as large is one level coarser, and axes, signs and the names of u and v do not matter") {
  std::mt19937 random(61);
  const auto number = [&] {
    return (static_cast<double>(random()) / 4294967296.0 - 0.5) * std::exp2(static_cast<double>(random() % 16) - 12);
  };
  for (int trial = 0; trial < 1000; ++trial) {
    const TextureDerivatives d{number(), number(), number(), number()};
    const int width = 1 << random() % 10, height = 1 << random() % 10;
    const double lod = level_of_detail(d, width, height);
    REQUIRE(level_of_detail({2 * d.dudx, 2 * d.dvdx, 2 * d.dudy, 2 * d.dvdy}, width, height) == Approx(lod + 1));
    REQUIRE(level_of_detail(d, 2 * width, 2 * height) == Approx(lod + 1));
    REQUIRE(level_of_detail({d.dudy, d.dvdy, d.dudx, d.dvdx}, width, height) == lod);
    REQUIRE(level_of_detail({-d.dudx, d.dvdx, d.dudy, -d.dvdy}, width, height) == lod);
    REQUIRE(level_of_detail({d.dvdx, d.dudx, d.dvdy, d.dudy}, height, width) == Approx(lod));
  }
}

TEST_CASE("only the trilinear filter has a level of detail, and no derivatives make it undefined") {
  const Texture texture = sized(256, 16);
  const TextureDerivatives coarse{1, 0, 0, 1};
  CHECK(lod_of_access(texture, Filter::nearest, coarse) == 0);
  CHECK(lod_of_access(texture, Filter::bilinear, coarse) == 0);
  CHECK(lod_of_access(texture, Filter::trilinear, coarse) == 8);
  CHECK(lod_of_access(sized(4, 16), Filter::trilinear, coarse) == 4);
  CHECK(level_of_detail({}, 256, 256) == finest_level_of_detail);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(level_of_detail({nan, nan, nan, nan}, 256, 256) == finest_level_of_detail);
}
