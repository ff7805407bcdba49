#include "memory/texture.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// Index of the texel row or column after wrapping.
int wrap_index(double index, int size, WrapMode mode) {
  if (index >= 0 && index < size) return static_cast<int>(index);  // nearly always, and divisions are slow
  if (mode == WrapMode::clamp) return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(size - 1)));
  const double turns = std::floor(index / size);
  return std::clamp(static_cast<int>(index - turns * size), 0, size - 1);  // rounding of a huge coordinate may land just outside
}

/// Coordinates that no texture can be asked for read the origin: the fetch unit has no way to refuse.
double defined(double coordinate) {
  return std::isfinite(coordinate) ? coordinate : 0.0;
}

/// std::floor, without the library call that it is for processors that cannot round in one instruction.
double floor_of(double value) {
  if (!(std::fabs(value) < 1e9)) return std::floor(value);
  const double cut = static_cast<int>(value);
  return cut > value ? cut - 1 : cut;
}

int nearest_level(const Texture& texture, double lod) {
  if (lod == 0) return 0;
  const double last = static_cast<double>(texture.levels.size() - 1);
  return static_cast<int>(std::clamp(std::floor(defined(lod) + 0.5), 0.0, last));
}

TexelTap nearest_tap(const Texture& texture, int level, double u, double v) {
  const auto& image = texture.levels[static_cast<std::size_t>(level)];
  return {level, wrap_index(std::floor(u * image.width), image.width, texture.wrap_u),
          wrap_index(std::floor(v * image.height), image.height, texture.wrap_v), 1.0};
}

void bilinear_taps(const Texture& texture, int level, double u, double v, double share, TexelTap taps[4]) {
  const auto& image = texture.levels[static_cast<std::size_t>(level)];
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  const double left = floor_of(x), low = floor_of(y);
  const double right_weight = x - left, high_weight = y - low;
  const int x0 = wrap_index(left, image.width, texture.wrap_u), x1 = wrap_index(left + 1, image.width, texture.wrap_u);
  const int y0 = wrap_index(low, image.height, texture.wrap_v), y1 = wrap_index(low + 1, image.height, texture.wrap_v);
  taps[0] = {level, x0, y0, share * (1 - right_weight) * (1 - high_weight)};
  taps[1] = {level, x1, y0, share * right_weight * (1 - high_weight)};
  taps[2] = {level, x0, y1, share * (1 - right_weight) * high_weight};
  taps[3] = {level, x1, y1, share * right_weight * high_weight};
}

const double* texel(const Texture& texture, const TexelTap& tap) {
  const auto& image = texture.levels[static_cast<std::size_t>(tap.level)];
  return &image.texels[(static_cast<std::size_t>(tap.y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(tap.x)) *
                       static_cast<std::size_t>(texture.channels)];
}

/// The difference of two angles in turns, the short way round.
double short_way(double difference) {
  return difference - std::floor(difference + 0.5);
}

double average(const double* values, int count, ChannelKind kind) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += kind == ChannelKind::angle ? short_way(values[i] - values[0]) : values[i];
  return kind == ChannelKind::angle ? short_way(values[0] + sum / count) : sum / count;
}

TextureLevel half_of(const TextureLevel& above, const Texture& texture) {
  TextureLevel level;
  level.width = std::max(1, (above.width + 1) / 2);
  level.height = std::max(1, (above.height + 1) / 2);
  const std::size_t channels = static_cast<std::size_t>(texture.channels);
  level.texels.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) * channels);
  std::size_t out = 0;
  for (int y = 0; y < level.height; ++y) {
    const std::size_t rows[2] = {static_cast<std::size_t>(2 * y), static_cast<std::size_t>(std::min(2 * y + 1, above.height - 1))};
    for (int x = 0; x < level.width; ++x) {
      const std::size_t columns[2] = {static_cast<std::size_t>(2 * x), static_cast<std::size_t>(std::min(2 * x + 1, above.width - 1))};
      for (std::size_t channel = 0; channel < channels; ++channel) {
        double four[4];
        for (std::size_t i = 0; i < 4; ++i) {
          four[i] = above.texels[(rows[i / 2] * static_cast<std::size_t>(above.width) + columns[i % 2]) * channels + channel];
        }
        level.texels[out++] = average(four, 4, texture.kinds[channel]);
      }
    }
  }
  return level;
}

}  // namespace

int texel_taps(const Texture& texture, Filter filter, double u, double v, double lod, TexelTap taps[8]) {
  BUMP_ASSERT(!texture.levels.empty());
  u = defined(u);
  v = defined(v);
  if (filter == Filter::nearest || !texture.filterable) {
    taps[0] = nearest_tap(texture, nearest_level(texture, lod), u, v);
    return 1;
  }
  if (filter == Filter::bilinear) {
    bilinear_taps(texture, nearest_level(texture, lod), u, v, 1.0, taps);
    return 4;
  }
  const double last = static_cast<double>(texture.levels.size() - 1);
  const double between = std::clamp(defined(lod), 0.0, last);
  const double finer = floor_of(between);
  const int level = static_cast<int>(finer);
  if (between == finer) {  // exactly on a level (always so when magnified): the other level would have weight 0
    bilinear_taps(texture, level, u, v, 1.0, taps);
    return 4;
  }
  bilinear_taps(texture, level, u, v, 1 - (between - finer), taps);
  bilinear_taps(texture, level + 1, u, v, between - finer, taps + 4);
  return 8;
}

void filter_texels(const Texture& texture, const TexelTap* taps, int count, double* out) {
  BUMP_ASSERT(count >= 1 && count <= 8);
  const double* at[8];
  for (int tap = 0; tap < count; ++tap) at[tap] = texel(texture, taps[tap]);
  for (int channel = 0; channel < texture.channels; ++channel) {
    const std::size_t index = static_cast<std::size_t>(channel);
    double sum = 0;
    if (texture.kinds[index] == ChannelKind::angle) {
      const double first = at[0][index];
      for (int tap = 0; tap < count; ++tap) sum += taps[tap].weight * short_way(at[tap][index] - first);
      out[index] = short_way(first + sum);
    } else {
      for (int tap = 0; tap < count; ++tap) sum += taps[tap].weight * at[tap][index];
      out[index] = sum;
    }
  }
}

void sample(const Texture& texture, Filter filter, double u, double v, double lod, double* out) {
  TexelTap taps[8];
  const int count = texel_taps(texture, filter, u, v, lod, taps);
  filter_texels(texture, taps, count, out);
}

void build_mip_levels(Texture& texture) {
  BUMP_ASSERT(!texture.levels.empty() && texture.channels > 0 && texture.kinds.size() == static_cast<std::size_t>(texture.channels));
  while (texture.levels.back().width > 1 || texture.levels.back().height > 1) {
    texture.levels.push_back(half_of(texture.levels.back(), texture));
  }
}

}  // namespace bump
