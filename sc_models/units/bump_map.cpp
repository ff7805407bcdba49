#include "units/bump_map.h"

#include <cmath>

#include "datapath/invariant.h"

namespace bump {

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
    for (std::size_t i = 0; i < level.texels.size(); ++i) {
      const Format& format = encoding.channels[i % channels].format;
      level.texels[i] = to_double(quantise(level.texels[i], format), format);
    }
  }
  return map;
}

}  // namespace bump
