#pragma once
// The four texels around a point of a texture level, and their weighted mean: the same numbers, bit for bit, as texel_taps() and
// filter_texels() of memory/texture.h give for the bilinear filter, found with integers where coordinates allow it. It exists because
// fetching texels is most of the work of a fragment. Part of the texture unit's time.

#include <algorithm>
#include <cmath>

#include "memory/texture.h"

namespace bump {

struct BilinearFootprint {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< columns left and right, rows below and above
  double right = 0, high = 0;          ///< weights of x1 and y1; x0 and y0 have the rest
};

/// floor() of a value that fits an int.
inline int floor_to_int(double value) {
  const int truncated = static_cast<int>(value);
  return truncated - (static_cast<double>(truncated) > value ? 1 : 0);
}

inline int wrap_texel(int index, int size, WrapMode mode) {
  if (mode == WrapMode::clamp) return std::clamp(index, 0, size - 1);
  if ((size & (size - 1)) == 0) return index & (size - 1);
  const int remainder = index % size;
  return remainder < 0 ? remainder + size : remainder;
}

/// False when the point is so far from the origin, or so undefined, that the general way is needed.
inline bool find_footprint(const Texture& texture, const TextureLevel& level, double u, double v, BilinearFootprint& f) {
  constexpr double limit = 1 << 24;
  const double x = u * level.width - 0.5, y = v * level.height - 0.5;
  if (!(std::fabs(x) < limit && std::fabs(y) < limit)) return false;
  const int left = floor_to_int(x), low = floor_to_int(y);
  f.right = x - left;
  f.high = y - low;
  f.x0 = wrap_texel(left, level.width, texture.wrap_u);
  f.x1 = wrap_texel(left + 1, level.width, texture.wrap_u);
  f.y0 = wrap_texel(low, level.height, texture.wrap_v);
  f.y1 = wrap_texel(low + 1, level.height, texture.wrap_v);
  return true;
}

/// Hands each channel's mean to `store(channel, value)`.
template <class Store>
void filter_footprint(const Texture& texture, const TextureLevel& level, const BilinearFootprint& f, Store&& store) {
  const auto channels = static_cast<std::size_t>(texture.channels), width = static_cast<std::size_t>(level.width);
  const auto texel = [&](int x, int y) {
    return level.texels.data() + (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * channels;
  };
  const double *t0 = texel(f.x0, f.y0), *t1 = texel(f.x1, f.y0), *t2 = texel(f.x0, f.y1), *t3 = texel(f.x1, f.y1);
  const double w0 = (1 - f.right) * (1 - f.high), w1 = f.right * (1 - f.high), w2 = (1 - f.right) * f.high, w3 = f.right * f.high;
  const auto short_way = [](double turns) { return turns - std::floor(turns + 0.5); };
  for (std::size_t c = 0; c < channels; ++c) {
    if (texture.kinds[c] == ChannelKind::linear) {
      store(c, 0.0 + w0 * t0[c] + w1 * t1[c] + w2 * t2[c] + w3 * t3[c]);
    } else {
      // Angles: the differences from the first texel, each the short way round.
      const double first = t0[c];
      store(c, short_way(first + (0.0 + w0 * short_way(t0[c] - first) + w1 * short_way(t1[c] - first) + w2 * short_way(t2[c] - first) +
                                  w3 * short_way(t3[c] - first))));
    }
  }
}

}  // namespace bump
