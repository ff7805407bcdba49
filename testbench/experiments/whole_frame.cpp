#include "testbench/experiments/whole_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "datapath/invariant.h"

namespace bump {

EightBitImage eight_bit(const FrameBuffer& frame) {
  EightBitImage image{frame.width, frame.height, std::vector<std::uint8_t>(frame.colour.size())};
  std::transform(frame.colour.begin(), frame.colour.end(), image.samples.begin(),
                 [](double value) { return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255 + 0.5)); });
  return image;
}

WholeFrameMeasures whole_frame_measures(const EightBitImage& test, const EightBitImage& reference) {
  BUMP_ASSERT(test.width == reference.width && test.height == reference.height);
  BUMP_ASSERT(test.samples.size() == reference.samples.size() && !reference.samples.empty() && reference.samples.size() % 3 == 0);
  std::array<std::int64_t, 3> squared{}, energy{};
  for (std::size_t i = 0; i < reference.samples.size(); ++i) {
    const std::int64_t wanted = reference.samples[i], error = wanted - test.samples[i];
    squared[i % 3] += error * error;
    energy[i % 3] += wanted * wanted;
  }
  WholeFrameMeasures measures;
  const double peak = 255.0 * 255.0 * static_cast<double>(reference.samples.size() / 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto error = static_cast<double>(squared[c]);
    measures.nmse[c] = squared[c] == 0  ? 0
                       : energy[c] == 0 ? std::numeric_limits<double>::quiet_NaN()
                                        : error / static_cast<double>(energy[c]);
    measures.pmse[c] = error / peak;
    measures.rnmse[c] = std::sqrt(measures.nmse[c]);
    measures.rpmse[c] = std::sqrt(measures.pmse[c]);
  }
  return measures;
}

}  // namespace bump
