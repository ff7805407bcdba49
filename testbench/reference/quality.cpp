#include "testbench/reference/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "datapath/invariant.h"

namespace bump {

namespace {

constexpr double depth_step = 1.0 / 16777216;  // 24 bits

std::size_t at(const FrameBuffer& frame, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x);
}

/// Change of depth from one pixel to the next along one axis: the smaller one of both sides, as the larger may cross an edge. 0 without a
/// neighbour on the same object.
double depth_slope(const FrameBuffer& frame, int x, int y, int dx, int dy) {
  double slope = std::numeric_limits<double>::infinity();
  for (const int side : {-1, 1}) {
    const int nx = x + side * dx, ny = y + side * dy;
    if (nx < 0 || ny < 0 || nx >= frame.width || ny >= frame.height) continue;
    if (frame.object[at(frame, nx, ny)] != frame.object[at(frame, x, y)]) continue;
    slope = std::min(slope, std::abs(frame.depth[at(frame, nx, ny)] - frame.depth[at(frame, x, y)]));
  }
  return std::isfinite(slope) ? slope : 0;
}

void check_sizes(const FrameBuffer& a, const FrameBuffer& b) {
  for (const FrameBuffer* frame : {&a, &b}) {
    const std::size_t pixels = static_cast<std::size_t>(frame->width) * static_cast<std::size_t>(frame->height);
    BUMP_ASSERT(frame->colour.size() == 3 * pixels && frame->object.size() == pixels && frame->depth.size() == pixels);
  }
  BUMP_ASSERT(a.width == b.width && a.height == b.height);
}

}  // namespace

bool same_surface(const FrameBuffer& test, const FrameBuffer& reference, int x, int y) {
  const std::size_t pixel = at(reference, x, y);
  if (test.object[pixel] != reference.object[pixel] || reference.object[pixel] < 0) return false;
  const double tolerance = 0.5 * (depth_slope(reference, x, y, 1, 0) + depth_slope(reference, x, y, 0, 1)) + depth_step;
  return std::abs(test.depth[pixel] - reference.depth[pixel]) <= tolerance;
}

Quality compare_frames(const FrameBuffer& test, const FrameBuffer& reference) {
  check_sizes(test, reference);
  Quality quality;
  std::array<double, 3> squared{}, energy{};
  double absolute = 0;
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      const std::size_t pixel = at(reference, x, y);
      if (test.object[pixel] < 0 && reference.object[pixel] < 0) continue;
      if (!same_surface(test, reference, x, y)) {
        ++quality.excluded;
        continue;
      }
      ++quality.pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const double wanted = reference.colour[pixel * 3 + c];
        const double error = wanted - test.colour[pixel * 3 + c];
        squared[c] += error * error;
        energy[c] += wanted * wanted;
        absolute += std::abs(error);
        quality.max_error = std::max(quality.max_error, 255 * std::abs(error));
      }
    }
  }

  const double nothing = std::numeric_limits<double>::quiet_NaN(), pixels = static_cast<double>(quality.pixels);
  const bool any = quality.pixels > 0;
  for (std::size_t c = 0; c < 3; ++c) {
    quality.nmse[c] = !any ? nothing : squared[c] == 0 ? 0 : energy[c] > 0 ? squared[c] / energy[c] : nothing;
    quality.pmse[c] = any ? squared[c] / pixels : nothing;
    quality.rnmse[c] = std::sqrt(quality.nmse[c]);
    quality.rpmse[c] = std::sqrt(quality.pmse[c]);
  }
  const double mean_squared = (squared[0] + squared[1] + squared[2]) / (3 * pixels);
  quality.psnr_db = !any ? nothing : mean_squared == 0 ? std::numeric_limits<double>::infinity() : -10 * std::log10(mean_squared);
  quality.mean_error = any ? 255 * absolute / (3 * pixels) : nothing;
  if (!any || std::isnan(mean_squared)) quality.max_error = nothing;  // std::max drops colours that are not numbers
  return quality;
}

FrameBuffer error_image(const FrameBuffer& test, const FrameBuffer& reference) {
  check_sizes(test, reference);
  constexpr double ramp[5][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  FrameBuffer image = reference;
  for (int y = 0; y < reference.height; ++y) {
    for (int x = 0; x < reference.width; ++x) {
      const std::size_t pixel = at(reference, x, y);
      double* colour = &image.colour[pixel * 3];
      if (test.object[pixel] < 0 && reference.object[pixel] < 0) {
        std::fill(colour, colour + 3, 0.0);
        continue;
      }
      if (!same_surface(test, reference, x, y)) {
        colour[0] = colour[2] = 0;
        colour[1] = 0.6;
        continue;
      }
      double error = 0;
      for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(test.colour[pixel * 3 + c] - reference.colour[pixel * 3 + c]));
      const double position = std::clamp(std::log2(1 + 255 * error) / 2, 0.0, 4.0);
      const int segment = std::min(static_cast<int>(position), 3);
      const double along = position - segment;
      for (int c = 0; c < 3; ++c) colour[c] = ramp[segment][c] * (1 - along) + ramp[segment + 1][c] * along;
    }
  }
  return image;
}

}  // namespace bump
