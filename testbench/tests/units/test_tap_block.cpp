// The taps and means of a block of accesses: bit for bit those of texel_taps() and filter_texels(), access by access.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "memory/level_of_detail.h"
#include "samples.h"
#include "units/tap_block.h"

namespace bump {
namespace {

struct Accesses {
  std::array<Lanes, 6> planes{};  // u, v, du/dx, dv/dx, du/dy, dv/dy
  AccessLanes lanes() const {
    return {planes[0].data(), planes[1].data(), planes[2].data(), planes[3].data(), planes[4].data(), planes[5].data()};
  }
};

/// Points inside and outside the texture, on texel centres and borders; pixels of up to `texels` texels of a texture of `size`.
Accesses random_accesses(std::mt19937& random, double size, double texels) {
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Accesses result;
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    for (std::size_t i = 0; i < 2; ++i) {
      double& at = result.planes[i][lane];
      at = 6 * number() - 3;
      if (random() % 3 == 0) at = std::floor(at * 4 * size) / (4 * size);
      if (random() % 5 == 0) at *= 1000;
      if (random() % 7 == 0) at = 0;
    }
    for (std::size_t i = 2; i < 6; ++i) result.planes[i][lane] = (2 * number() - 1) * texels / size;
  }
  return result;
}

bool same_bits(double a, double b) {
  return (a == b && std::signbit(a) == std::signbit(b)) || (std::isnan(a) && std::isnan(b));
}

/// Compares a block with the general functions. Returns whether it was found with vectors.
bool agree(const Texture& texture, const TextureLayout& layout, int line_shift, Filter filter, const Accesses& at, int lanes) {
  TapBlock block;
  REQUIRE(TapBlock::can_hold(texture, layout));
  block.find(texture, layout, line_shift, filter, at.lanes(), lanes);
  std::vector<Lanes> means(static_cast<std::size_t>(texture.channels));
  block.weigh(texture, lanes, means.data());
  bool same = true;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    const auto& p = at.planes;
    const double lod = lod_of_access(texture, filter, {p[2][lane], p[3][lane], p[4][lane], p[5][lane]});
    TexelTap taps[8];
    const int count = texel_taps(texture, filter, p[0][lane], p[1][lane], lod, taps);
    same = same && block.taps_of(lane) == count;
    const std::uint64_t first = layout.address(0, 0, 0) >> line_shift;
    for (std::size_t tap = 0; tap < block.taps(); ++tap) {
      const TexelTap& one = taps[tap < static_cast<std::size_t>(count) ? tap : 0];
      same = same && first + block.line(tap)[lane] == layout.address(one.level, one.x, one.y) >> line_shift;
    }
    std::vector<double> expected(static_cast<std::size_t>(texture.channels));
    filter_texels(texture, taps, count, expected.data());
    for (std::size_t c = 0; c < expected.size(); ++c) same = same && same_bits(means[c][lane], expected[c]);
  }
  CHECK(same);
  return block.is_uniform();
}

TEST_CASE("a block of accesses has the taps, lines and means of the general filter, bit for bit") {
  std::mt19937 random(51);
  int with_vectors = 0, one_by_one = 0;
  for (const auto& [width, height] : {std::pair<int, int>{16, 8}, {7, 12}, {1, 5}, {33, 1}, {640, 3}}) {
    for (const int channels : {1, 2, 3, 4, 5}) {
      auto texture = samples::texture(width, height, channels, 9);
      for (TextureLevel& level : texture->levels)
        for (std::size_t i = 0; i < level.texels.size(); i += 3) level.texels[i] = i % 2 == 0 ? -level.texels[i] : -0.0;
      for (const WrapMode wrap : {WrapMode::repeat, WrapMode::clamp}) {
        texture->wrap_u = wrap;
        texture->wrap_v = random() % 2 == 0 ? WrapMode::repeat : WrapMode::clamp;
        texture->filterable = random() % 4 != 0;
        texture->bytes_per_texel = 1 << random() % 4;
        texture->kinds[random() % static_cast<unsigned>(channels)] = random() % 2 == 0 ? ChannelKind::angle : ChannelKind::linear;
        for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
          for (const double texels : {0.5, 6.0}) {
            const int line_shift = 3 + static_cast<int>(random() % 5);
            const TextureLayout layout(*texture, random() % 1000, 1 << line_shift);
            const Accesses at = random_accesses(random, std::max(width, height), texels);
            const bool vectors = agree(*texture, layout, line_shift, filter, at, 1 + static_cast<int>(random() % block_lanes));
            ++(vectors ? with_vectors : one_by_one);
            // Minified blocks read several levels, all others one.
            CHECK((vectors || (filter == Filter::trilinear && texels > 1)));
          }
        }
      }
    }
  }
  CHECK(with_vectors > 100);
  CHECK(one_by_one > 20);
}

TEST_CASE("accesses far away or without coordinates read what the general filter reads") {
  std::mt19937 random(52);
  auto texture = samples::texture(24, 16, 3, 4);
  const TextureLayout layout(*texture, 0, 64);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const double odd : {std::nan(""), infinite, -infinite, 1e30, -3e9, 2e7}) {
    for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear}) {
      for (const std::size_t plane : {0U, 1U}) {
        Accesses at = random_accesses(random, 24, 0.5);
        at.planes[plane][random() % block_lanes] = odd;
        CHECK(!agree(*texture, layout, 6, filter, at, block_lanes));
      }
    }
    Accesses at = random_accesses(random, 24, 0.5);
    at.planes[2 + random() % 4][7] = odd;
    agree(*texture, layout, 6, Filter::trilinear, at, block_lanes);
  }
}

TEST_CASE("texels that are no numbers come out as the general filter has them") {
  std::mt19937 random(53);
  auto texture = samples::texture(8, 8, 2, 4);
  texture->kinds[1] = ChannelKind::angle;
  for (std::size_t i = 0; i < 128; i += 7)
    texture->levels[0].texels[i] = i % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
  const TextureLayout layout(*texture, 0, 64);
  for (const Filter filter : {Filter::nearest, Filter::bilinear})
    CHECK(agree(*texture, layout, 6, filter, random_accesses(random, 8, 0.5), block_lanes));
}

TEST_CASE("a texture whose texels cannot be numbered in 32 bits is not held") {
  Texture texture;
  texture.channels = 3;
  texture.levels.push_back({1 << 15, (1 << 15) - 4, {}});
  CHECK(!TapBlock::can_hold(texture, TextureLayout(texture, 0, 64)));
  texture.channels = 1;
  CHECK(TapBlock::can_hold(texture, TextureLayout(texture, 0, 64)));
  texture.bytes_per_texel = 8;
  CHECK(!TapBlock::can_hold(texture, TextureLayout(texture, 0, 64)));
}

}  // namespace
}  // namespace bump
