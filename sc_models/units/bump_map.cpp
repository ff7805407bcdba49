#include "units/bump_map.h"

#include <cmath>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "datapath/lane_math.h"

namespace bump {

namespace {

// As quantise() and to_double(), for many values, `stride` apart; words of at most narrow_bits. Whole numbers stay doubles.

BUMP_LANE_LOOP void quantise_numbers(double* values, std::size_t count, std::size_t stride, double step, double lowest, double highest) {
  const double scale = 1 / step;
  for (std::size_t i = 0; i < count * stride; i += stride) {
    const double scaled = values[i] * scale, number = scaled == scaled ? scaled : 0.0;
    const double below = number < highest ? number : highest;
    values[i] = round_half_up(below > lowest ? below : lowest) * step;
  }
}

/// `half`: half a turn in steps.
BUMP_LANE_LOOP void quantise_turns(double* values, std::size_t count, std::size_t stride, double step, double half) {
  const double scale = 1 / step;
  for (std::size_t i = 0; i < count * stride; i += stride) {
    const double turn = to_half_open_turn(values[i]), number = turn == turn ? turn : 0.0;
    const double whole = round_half_up(number * scale);
    values[i] = (whole >= half ? whole - 2 * half : whole) * step;
  }
}

}  // namespace

int bytes_per_texel(const BumpEncoding& encoding) {
  int bits = 0, bytes = 1;
  for (const BumpEncoding::Channel& channel : encoding.channels) bits += channel.format.width;
  while (8 * bytes < bits) bytes *= 2;
  return bytes;
}

Texture encode_bump_map(const Texture& normals, const BumpEncoding& encoding) {
  BUMP_ASSERT(normals.channels == 3 && !encoding.channels.empty());
  Texture map;
  map.name = normals.name;
  map.channels = static_cast<int>(encoding.channels.size());
  for (const BumpEncoding::Channel& channel : encoding.channels) map.kinds.push_back(channel.kind);
  map.bytes_per_texel = bytes_per_texel(encoding);
  map.wrap_u = normals.wrap_u;
  map.wrap_v = normals.wrap_v;
  map.filterable = encoding.filterable;
  for (const TextureLevel& from : normals.levels) {
    TextureLevel level{from.width, from.height, {}};
    const std::size_t texels = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
    level.texels.resize(texels * encoding.channels.size());
    for (std::size_t i = 0; i < texels; ++i) {
      const glm::dvec3 sum{from.texels[3 * i], from.texels[3 * i + 1], from.texels[3 * i + 2]};
      const double length = glm::length(sum);
      encoding.encode(length > 0 ? sum / length : glm::dvec3{0, 0, 1}, &level.texels[i * encoding.channels.size()]);
    }
    map.levels.push_back(std::move(level));
  }
  return map;
}

Texture quantise_texels(Texture map, const BumpEncoding& encoding) {
  const std::size_t channels = encoding.channels.size();
  for (TextureLevel& level : map.levels) {
    const std::size_t texels = level.texels.size() / channels;
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const Format& format = encoding.channels[channel].format;
      double* values = level.texels.data() + channel;
      if (format.width > narrow_bits) {
        for (std::size_t i = 0; i < texels; ++i) values[i * channels] = to_double(quantise(values[i * channels], format), format);
      } else if (format.wraps()) {
        quantise_turns(values, texels, channels, format.step(), std::ldexp(1.0, format.width - 1));
      } else {
        quantise_numbers(values, texels, channels, format.step(), format.lowest() / format.step(), format.highest() / format.step());
      }
    }
  }
  return map;
}

}  // namespace bump
