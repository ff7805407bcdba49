#include "units/edge_function.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"

namespace bump {

EdgeFunctions::EdgeFunctions(const SetupTriangle& triangle, int subpixel_bits) {
  BUMP_ASSERT(subpixel_bits >= 1);
  std::array<std::int64_t, 3> x{}, y{};
  for (std::size_t c = 0; c < 3; ++c) {
    x[c] = static_cast<std::int64_t>(std::ldexp(triangle.x[c], subpixel_bits));
    y[c] = static_cast<std::int64_t>(std::ldexp(triangle.y[c], subpixel_bits));
  }
  const std::int64_t signed_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  BUMP_ASSERT(signed_area != 0);
  const std::int64_t sign = signed_area > 0 ? 1 : -1;
  area_ = signed_area * sign;
  const std::int64_t pixel = std::int64_t{1} << subpixel_bits, centre = pixel / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const std::int64_t dx = (x[k] - x[j]) * sign, dy = (y[k] - y[j]) * sign;
    origin_[i] = dx * (centre - y[j]) - dy * (centre - x[j]);
    across_[i] = -dy * pixel;
    down_[i] = dx * pixel;
    // y points down and the edge function is positive inside: left edges run upwards, top edges to the right. Centres on other edges are
    // outside.
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    bias_[i] = top_left ? 0 : 1;
  }
  const auto pixel_of = [&](std::int64_t coordinate) { return static_cast<int>(floor_divide(coordinate, pixel)); };
  top_ = pixel_of(*std::min_element(y.begin(), y.end()));
  bottom_ = pixel_of(*std::max_element(y.begin(), y.end()));
  left_ = pixel_of(*std::min_element(x.begin(), x.end()));
  right_ = pixel_of(*std::max_element(x.begin(), x.end()));
}

PixelSpan EdgeFunctions::span(int y, int left, int right) const {
  std::int64_t first = left, last = right;
  for (std::size_t i = 0; i < 3; ++i) {
    // Inside means value + across * x >= 0.
    const std::int64_t value = origin_[i] + down_[i] * y - bias_[i], across = across_[i];
    if (across > 0) {
      first = std::max(first, -floor_divide(value, across));
    } else if (across < 0) {
      last = std::min(last, floor_divide(value, -across));
    } else if (value < 0) {
      return {};
    }
  }
  if (first > last) return {};
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace bump
