#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "memory/texture.h"

using namespace bump;

namespace {

Texture random_texture(int width, int height, int channels, ChannelKind kind, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0 - (kind == ChannelKind::angle ? 0.5 : 0.0); };
  Texture texture;
  texture.channels = channels;
  texture.kinds.assign(static_cast<std::size_t>(channels), kind);
  TextureLevel level{width, height, {}};
  for (int i = 0; i < width * height * channels; ++i) level.texels.push_back(next());
  texture.levels.push_back(level);
  return texture;
}

double texel(const Texture& texture, std::size_t level, int x, int y, int channel) {
  const auto& image = texture.levels[level];
  return image.texels[static_cast<std::size_t>((y * image.width + x) * texture.channels + channel)];
}

}  // namespace

TEST_CASE("filter weights are not negative and sum to 1, and taps stay inside the texture") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-5, 5);
  for (int trial = 0; trial < 3000; ++trial) {
    Texture texture = random_texture(1 + static_cast<int>(random() % 9), 1 + static_cast<int>(random() % 9), 1, ChannelKind::linear, 1);
    texture.wrap_u = random() % 2 == 0 ? WrapMode::repeat : WrapMode::clamp;
    texture.wrap_v = random() % 2 == 0 ? WrapMode::repeat : WrapMode::clamp;
    build_mip_levels(texture);
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
      TexelTap taps[8];
      const int count = texel_taps(texture, filter, anywhere(random), anywhere(random), anywhere(random), taps);
      REQUIRE((count == 1 || count == 4 || count == 8));
      double sum = 0;
      for (int i = 0; i < count; ++i) {
        REQUIRE(taps[i].level >= 0);
        REQUIRE(taps[i].level < static_cast<int>(texture.levels.size()));
        const auto& level = texture.levels[static_cast<std::size_t>(taps[i].level)];
        REQUIRE((taps[i].x >= 0 && taps[i].x < level.width && taps[i].y >= 0 && taps[i].y < level.height));
        REQUIRE(taps[i].weight >= 0);
        sum += taps[i].weight;
      }
      REQUIRE(sum == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("at a texel's centre every filter gives that texel") {
  Texture texture = random_texture(8, 4, 2, ChannelKind::linear, 3);
  build_mip_levels(texture);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
        double out[2];
        sample(texture, filter, (x + 0.5) / 8, (y + 0.5) / 4, -1, out);
        CHECK(out[0] == Approx(texel(texture, 0, x, y, 0)).margin(1e-12));
        CHECK(out[1] == Approx(texel(texture, 0, x, y, 1)).margin(1e-12));
      }
    }
  }
}

TEST_CASE("a repeated texture has period 1, a clamped one goes on with its border") {
  Texture texture = random_texture(8, 8, 1, ChannelKind::linear, 5);
  double inside, outside;
  for (int i = 0; i < 100; ++i) {
    const double u = i / 128.0, v = (100 - i) / 128.0;
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
      sample(texture, filter, u, v, 0, &inside);
      sample(texture, filter, u + 3, v - 2, 0, &outside);
      CHECK(inside == Approx(outside).margin(1e-12));
    }
  }
  texture.wrap_u = texture.wrap_v = WrapMode::clamp;
  sample(texture, Filter::bilinear, -7, 9, 0, &outside);
  CHECK(outside == texel(texture, 0, 0, 7, 0));
}

TEST_CASE("a linear ramp is reproduced between texel centres") {
  Texture texture = random_texture(16, 16, 1, ChannelKind::linear, 1);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) texture.levels[0].texels[static_cast<std::size_t>(16 * y + x)] = 3 * (x + 0.5) / 16 - 2 * (y + 0.5) / 16;
  }
  for (int i = 0; i < 50; ++i) {
    const double u = 0.05 + 0.018 * i, v = 0.95 - 0.017 * i;
    double out;
    sample(texture, Filter::bilinear, u, v, 0, &out);
    CHECK(out == Approx(3 * u - 2 * v).margin(1e-12));
  }
}

TEST_CASE("trilinear filtering runs from level to level without a jump") {
  Texture texture = random_texture(16, 16, 1, ChannelKind::linear, 11);
  build_mip_levels(texture);
  double below, between, above;
  sample(texture, Filter::trilinear, 0.3, 0.6, 1, &below);
  sample(texture, Filter::trilinear, 0.3, 0.6, 1.25, &between);
  sample(texture, Filter::trilinear, 0.3, 0.6, 2, &above);
  CHECK(between == Approx(0.75 * below + 0.25 * above));
  double bilinear;
  sample(texture, Filter::bilinear, 0.3, 0.6, 1.4, &bilinear);
  CHECK(bilinear == below);
  sample(texture, Filter::trilinear, 0.3, 0.6, 99, &above);
  CHECK(above == texture.levels.back().texels[0]);
}

TEST_CASE("angles are filtered the short way round") {
  Texture texture;
  texture.channels = 1;
  texture.kinds = {ChannelKind::angle};
  texture.wrap_u = texture.wrap_v = WrapMode::clamp;
  texture.levels.push_back({2, 1, {0.45, -0.45}});
  double out;
  sample(texture, Filter::bilinear, 0.5, 0.5, 0, &out);
  CHECK(std::abs(out) == Approx(0.5));
  sample(texture, Filter::bilinear, 0.25 + 0.125, 0.5, 0, &out);
  CHECK(out == Approx(0.475));

  // Turning every texel by the same angle turns what is read by that angle.
  Texture spread = random_texture(8, 8, 1, ChannelKind::angle, 13);
  for (double& value : spread.levels[0].texels) value *= 0.4;
  Texture turned = spread;
  for (double& value : turned.levels[0].texels) value = value + 0.37 - std::floor(value + 0.37 + 0.5);
  for (int i = 0; i < 200; ++i) {
    double original, moved;
    sample(spread, Filter::bilinear, 0.01 * i, 0.017 * i, 0, &original);
    sample(turned, Filter::bilinear, 0.01 * i, 0.017 * i, 0, &moved);
    const double difference = moved - original - 0.37;
    CHECK(difference - std::floor(difference + 0.5) == Approx(0).margin(1e-12));
    CHECK(moved >= -0.5);
    CHECK(moved < 0.5);
  }
}

TEST_CASE("a map that cannot be filtered gives single texels whatever the filter") {
  Texture texture = random_texture(8, 8, 1, ChannelKind::linear, 17);
  texture.filterable = false;
  build_mip_levels(texture);
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
    TexelTap taps[8];
    REQUIRE(texel_taps(texture, filter, 0.55, 0.31, 0.7, taps) == 1);
    CHECK(taps[0].level == 1);
    CHECK(taps[0].x == 2);
    CHECK(taps[0].y == 1);
  }
}

TEST_CASE("mip levels halve down to one texel and keep the average") {
  for (const auto& [width, height] : {std::pair<int, int>{8, 8}, {16, 4}, {1, 32}, {1, 1}}) {
    Texture texture = random_texture(width, height, 1, ChannelKind::linear, 19);
    double mean = 0;
    for (const double value : texture.levels[0].texels) mean += value / (width * height);
    build_mip_levels(texture);
    for (std::size_t level = 1; level < texture.levels.size(); ++level) {
      CHECK(texture.levels[level].width == std::max(1, texture.levels[level - 1].width / 2));
      CHECK(texture.levels[level].height == std::max(1, texture.levels[level - 1].height / 2));
    }
    CHECK(texture.levels.back().texels.size() == 1);
    CHECK(texture.levels.back().texels[0] == Approx(mean));
  }
}

TEST_CASE("odd levels repeat their last row and column") {
  Texture texture = random_texture(3, 3, 1, ChannelKind::linear, 23);
  build_mip_levels(texture);
  REQUIRE(texture.levels[1].width == 2);
  REQUIRE(texture.levels[1].height == 2);
  CHECK(texel(texture, 1, 1, 1, 0) == Approx(texel(texture, 0, 2, 2, 0)));
  CHECK(texel(texture, 1, 1, 0, 0) == Approx((texel(texture, 0, 2, 0, 0) + texel(texture, 0, 2, 1, 0)) / 2));
}

TEST_CASE("coordinates that are not finite or huge still read a texel") {
  Texture texture = random_texture(4, 4, 1, ChannelKind::linear, 29);
  build_mip_levels(texture);
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double u : {nan, infinite, -infinite, 1e300, -1e17}) {
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
      double out = -1;
      sample(texture, filter, u, u, u, &out);
      CHECK(out >= 0);
      CHECK(out <= 1);
    }
  }
}
