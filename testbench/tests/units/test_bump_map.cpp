#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "units/bump_map.h"

using namespace bump;

namespace {

Texture map_of(const std::vector<double>& values, int channels) {
  Texture map;
  map.channels = channels;
  map.kinds.assign(static_cast<std::size_t>(channels), ChannelKind::linear);
  map.levels.push_back({static_cast<int>(values.size()) / channels, 1, values});
  return map;
}

/// Ends and middles of steps, values beyond both ends of every word, and no numbers at all.
std::vector<double> awkward_values() {
  std::vector<double> values{
      0.0, -0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), std::nan(""), 1e300, -1e300, 1e-300};
  for (int i = -3000; i <= 3000; ++i) values.push_back(i / 1024.0);
  std::uint32_t state = 11;
  for (int i = 0; i < 4000; ++i) {
    state = state * 1664525u + 1013904223u;
    values.push_back((static_cast<double>(state >> 8) / 8388608.0 - 1) * (i % 3 == 0 ? 300.0 : 1.2));
  }
  while (values.size() % 6 != 0) values.push_back(0.5);
  return values;
}

}  // namespace

TEST_CASE("a stored texel is the nearest word of its channel's format, to the last bit") {
  const std::vector<Format> formats{turns(10),     turns(16),    uangle(9, 10),  angle(12, 14),  sfixed(8, 7), ufixed(8, 8),
                                    sfixed(12, 8), sfixed(1, 0), ufixed(50, 40), sfixed(56, 50), turns(60)};
  const std::vector<double> values = awkward_values();
  for (const int channels : {1, 2, 3}) {
    for (std::size_t first = 0; first < formats.size(); ++first) {
      BumpEncoding encoding;
      for (int c = 0; c < channels; ++c)
        encoding.channels.push_back({"c", formats[(first + static_cast<std::size_t>(c)) % formats.size()], ChannelKind::linear});
      const Texture stored = quantise_texels(map_of(values, channels), encoding);
      std::size_t different = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const Format& format = encoding.channels[i % static_cast<std::size_t>(channels)].format;
        const double word = to_double(quantise(values[i], format), format), got = stored.levels[0].texels[i];
        different += got != word || std::signbit(got) != std::signbit(word) ? 1u : 0u;
      }
      INFO(channels << " channels from " << to_string(formats[first]));
      CHECK(different == 0);
    }
  }
}
