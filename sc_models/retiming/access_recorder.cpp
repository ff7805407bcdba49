#include "retiming/access_recorder.h"

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

void require(bool holds, const char* what) {
  if (!holds) throw Error(ErrorKind::internal, {"the timing trace contradicts itself: " + std::string(what), {}, "", "record it again"});
}

void check_texel(const std::vector<Texture>& textures, std::int32_t texture, const Footprint& at) {
  require(texture >= 0 && static_cast<std::size_t>(texture) < textures.size(), "a texture that is not there");
  const std::vector<TextureLevel>& levels = textures[static_cast<std::size_t>(texture)].levels;
  require(at.level >= 0 && static_cast<std::size_t>(at.level) < levels.size(), "a level that the texture does not have");
  const TextureLevel& level = levels[static_cast<std::size_t>(at.level)];
  require(at.x >= 0 && at.x < level.width && at.y >= 0 && at.y < level.height, "a texel outside its texture");
}

}  // namespace

void check_accesses(const RecordedAccesses& accesses) {
  constexpr std::int64_t longest = 1 << 24, most_texels = std::int64_t{1} << 31;
  for (const Texture& texture : accesses.textures) {
    require(!texture.levels.empty() && texture.bytes_per_texel >= 1 && texture.bytes_per_texel <= 4096, "a texture without texels");
    for (const TextureLevel& level : texture.levels)
      require(level.width >= 1 && level.height >= 1 && level.width <= longest && level.height <= longest &&
                  std::int64_t{level.width} * level.height < most_texels,
              "a texture of no size");
  }
  for (AccessReader texels(accesses.texels); texels.next();) {
    const FragmentAccess& access = texels.access();
    require(access.levels[0] >= 1, "a fragment that reads nothing");
    for (std::size_t t = 0; t < 2; ++t)
      for (std::size_t i = 0; i < access.levels[t]; ++i) check_texel(accesses.textures, access.texture[t], access.at[2 * t + i]);
  }
  for (AccessReader words(accesses.words); words.next();) {
    const FragmentAccess& access = words.access();
    const Footprint& at = access.at[0];
    require(access.levels[0] == 1 && access.levels[1] == 0 && access.texture[0] >= 0 && at.level == 0 && at.x >= 0 && at.y >= 0 &&
                at.x <= longest && at.y <= longest,
            "a word that no light map has");
  }
}

void AccessRecorder::add_texture(const Texture& texture) {
  Texture shape;
  shape.channels = texture.channels;
  shape.bytes_per_texel = texture.bytes_per_texel;
  shape.wrap_u = texture.wrap_u;
  shape.wrap_v = texture.wrap_v;
  shape.filterable = texture.filterable;
  for (const TextureLevel& level : texture.levels) {
    shape.levels.emplace_back();
    shape.levels.back().width = level.width;
    shape.levels.back().height = level.height;
  }
  textures_.push_back(std::move(shape));
}

Footprint AccessRecorder::footprint(const Texture& texture, const TapBlock& taps, std::size_t first, std::size_t lane, bool is_lone) const {
  Footprint found;
  found.level = taps.level(first, lane);
  const TextureLevel& level = texture.levels[static_cast<std::size_t>(found.level)];
  const auto texel = [&](std::size_t tap) { return taps.texel(first + tap)[lane] / texture.channels; };
  const std::int32_t lower_left = texel(0);
  found.x = lower_left % level.width;
  found.y = lower_left / level.width;
  if (is_lone) return found;
  const std::int32_t right = texel(1) % level.width, above = texel(2) / level.width;
  if (right != next_texel(found.x, level.width, texture.wrap_u, false)) found.sides |= 1U;
  if (above != next_texel(found.y, level.height, texture.wrap_v, false)) found.sides |= 2U;
  BUMP_ASSERT((found.sides & 1U) == 0 || right == found.x);
  BUMP_ASSERT((found.sides & 2U) == 0 || above == found.y);
  return found;
}

void AccessRecorder::add_texels(const std::array<int, 2>& textures, const std::array<TapBlock, 2>& taps, int lanes) {
  FragmentAccess access;
  for (std::size_t t = 0; t < 2; ++t) access.texture[t] = textures[t];
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    for (std::size_t t = 0; t < 2; ++t) {
      if (textures[t] < 0) continue;
      const Texture& texture = textures_[static_cast<std::size_t>(textures[t])];
      const int count = taps[t].taps_of(lane);
      access.levels[t] = count > 4 ? 2 : 1;
      for (std::size_t i = 0; i < access.levels[t]; ++i) access.at[2 * t + i] = footprint(texture, taps[t], 4 * i, lane, count == 1);
    }
    texels_.append(access);
  }
}

void AccessRecorder::add_words(int object, int column_bits, const std::vector<std::int64_t>& entries, int lanes) {
  FragmentAccess access;
  access.texture[0] = object;
  access.levels[0] = 1;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
    access.at[0].x = static_cast<std::int32_t>(entries[lane] & ((std::int64_t{1} << column_bits) - 1));
    access.at[0].y = static_cast<std::int32_t>(entries[lane] >> column_bits);
    words_.append(access);
  }
}

RecordedAccesses AccessRecorder::finish() {
  return {std::move(textures_), texels_.finish(), words_.finish()};
}

}  // namespace bump
