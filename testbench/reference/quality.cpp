#include "testbench/reference/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "testbench/reference/row_bands.h"

namespace bump {

namespace {

constexpr double depth_step = 1.0 / 16777216;  // 24 bits
constexpr int rows_of_band = 32;

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

enum Verdict : std::uint8_t { background, excluded, compared };

/// A row of the frames: where it begins, and the rows above and below in the reference; at the border, a row of no object.
struct SurfaceRow {
  const std::int32_t *test_object, *object, *object_above, *object_below;
  const double *test_depth, *depth, *depth_above, *depth_below;
};

/// What depth_slope and same_surface say, for pixels that have neighbours on both sides.
BUMP_LANE_LOOP void judge_inner(const SurfaceRow& row, int width, std::uint8_t* __restrict verdict) {
  const std::int32_t *object = row.object, *above = row.object_above, *below = row.object_below, *test = row.test_object;
  const double *depth = row.depth, *depth_above = row.depth_above, *depth_below = row.depth_below, *test_depth = row.test_depth;
  const double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
  for (int x = 1; x < width - 1; ++x) {
    const std::int32_t here = object[x];
    const double d = depth[x];
    const double left = object[x - 1] == here ? std::abs(depth[x - 1] - d) : infinity;
    const double right = object[x + 1] == here ? std::abs(depth[x + 1] - d) : infinity;
    const double up = above[x] == here ? std::abs(depth_above[x] - d) : infinity;
    const double down = below[x] == here ? std::abs(depth_below[x] - d) : infinity;
    const double least_across = left < infinity ? left : infinity, least_along = up < infinity ? up : infinity;
    const double across = right < least_across ? right : least_across, along = down < least_along ? down : least_along;
    const double tolerance = 0.5 * ((across <= largest ? across : 0.0) + (along <= largest ? along : 0.0)) + depth_step;
    const bool is_same = (test[x] == here) & (here >= 0) & (std::abs(test_depth[x] - d) <= tolerance);
    const bool is_background = (test[x] < 0) & (here < 0);
    verdict[x] = static_cast<std::uint8_t>(is_background ? background : is_same ? compared : excluded);
  }
}

/// Judges the pixels of a frame row by row.
class Judge {
 public:
  Judge(const FrameBuffer& test, const FrameBuffer& reference)
      : test_(test),
        reference_(reference),
        verdict_(static_cast<std::size_t>(reference.width)),
        no_object_(static_cast<std::size_t>(reference.width), std::numeric_limits<std::int32_t>::min()) {}

  /// A verdict for every pixel of row y; valid until the next call.
  const std::uint8_t* row(int y) {
    const int width = reference_.width;
    if (width == 0) return verdict_.data();
    const std::size_t begin = at(reference_, 0, y), step = static_cast<std::size_t>(width);
    const bool is_top = y == 0, is_bottom = y == reference_.height - 1;
    const std::int32_t* object = &reference_.object[begin];
    const double* depth = &reference_.depth[begin];
    const SurfaceRow row = {&test_.object[begin],
                            object,
                            is_top ? no_object_.data() : object - step,
                            is_bottom ? no_object_.data() : object + step,
                            &test_.depth[begin],
                            depth,
                            is_top ? depth : depth - step,
                            is_bottom ? depth : depth + step};
    judge_inner(row, width, verdict_.data());
    judge_one(0, y);
    judge_one(width - 1, y);
    return verdict_.data();
  }

 private:
  void judge_one(int x, int y) {
    const std::size_t pixel = at(reference_, x, y);
    const bool is_background = test_.object[pixel] < 0 && reference_.object[pixel] < 0;
    verdict_[static_cast<std::size_t>(x)] = is_background ? background : same_surface(test_, reference_, x, y) ? compared : excluded;
  }

  const FrameBuffer &test_, &reference_;
  std::vector<std::uint8_t> verdict_;
  const std::vector<std::int32_t> no_object_;
};

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

Quality compare_frames(const FrameBuffer& test, const FrameBuffer& reference, const std::vector<std::uint8_t>* left_out) {
  check_sizes(test, reference);
  BUMP_ASSERT(left_out == nullptr || left_out->size() == test.object.size());
  Quality quality;
  std::array<double, 3> squared{}, energy{};
  double absolute = 0, largest = 0;
  Judge judge(test, reference);
  for (int y = 0; y < reference.height; ++y) {
    const std::uint8_t* verdict = judge.row(y);
    for (int x = 0; x < reference.width; ++x) {
      if (verdict[x] == background) continue;
      const std::size_t pixel = at(reference, x, y);
      if (left_out != nullptr && (*left_out)[pixel] != 0) {
        if (reference.object[pixel] >= 0) ++quality.excluded;
        continue;
      }
      if (verdict[x] == excluded) {
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
        largest = std::max(largest, 255 * std::abs(error));
      }
    }
  }
  quality.max_error = largest;

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

FrameBuffer error_image(const FrameBuffer& test, FrameBuffer reference, int threads) {
  check_sizes(test, reference);
  constexpr double ramp[5][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}};
  FrameBuffer image = std::move(reference);  // only colours change, and surfaces are judged by the rest
  for_row_bands(image.height, rows_of_band, threads, [&](int first_row, int end_row) {
    Judge judge(test, image);
    for (int y = first_row; y < end_row; ++y) {
      const std::uint8_t* verdict = judge.row(y);
      for (int x = 0; x < image.width; ++x) {
        const std::size_t pixel = at(image, x, y);
        double* colour = &image.colour[pixel * 3];
        if (verdict[x] != compared) {
          colour[0] = colour[2] = 0;
          colour[1] = verdict[x] == background ? 0 : 0.6;
          continue;
        }
        double error = 0;
        for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(test.colour[pixel * 3 + c] - colour[c]));
        const double position = std::clamp(std::log2(1 + 255 * error) / 2, 0.0, 4.0);
        const int segment = std::min(static_cast<int>(position), 3);
        const double along = position - segment;
        for (int c = 0; c < 3; ++c) colour[c] = ramp[segment][c] * (1 - along) + ramp[segment + 1][c] * along;
      }
    }
  });
  return image;
}

}  // namespace bump
