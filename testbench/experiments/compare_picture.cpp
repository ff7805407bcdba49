#include "testbench/experiments/compare_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "datapath/invariant.h"
#include "testbench/experiments/label.h"

namespace bump {

namespace {

constexpr int gap = 8;             ///< pixels between frames and around them
constexpr double backdrop = 0.25;  ///< grey, on which both black frames and white letters show

int ceiling(int number, int by) {
  return (number + by - 1) / by;
}

/// Letters about a twentieth of the frame's width high, as far as the longest line fits above its frame; never smaller than one pixel a
/// dot.
int label_scale(const PictureGrid& grid, const std::vector<LabelledFrame>& frames) {
  int scale = std::max(1, grid.width / 20 / glyph_rows);
  for (const LabelledFrame& frame : frames)
    for (const std::string& line : frame.label)
      while (scale > 1 && label_width(line, scale) > grid.width) --scale;
  return scale;
}

void paste(const SmallFrame& frame, FrameBuffer& picture, int left, int top) {
  const std::size_t row = 3 * static_cast<std::size_t>(frame.width);
  for (int y = 0; y < frame.height; ++y) {
    const auto from = frame.colour.begin() + static_cast<std::ptrdiff_t>(row) * y;
    const std::size_t to =
        3 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(left));
    std::transform(from, from + static_cast<std::ptrdiff_t>(row), picture.colour.begin() + static_cast<std::ptrdiff_t>(to),
                   [](std::uint8_t value) { return value / 255.0; });
  }
}

}  // namespace

PictureGrid::PictureGrid(int frame_width, int frame_height, int count) {
  BUMP_ASSERT(frame_width > 0 && frame_height > 0 && count > 0);
  // As near to 3 : 2 as whole frames allow, with a price on every empty place.
  double best = 1e300;
  for (int candidate = 1; candidate <= count; ++candidate) {
    const int lines = ceiling(count, candidate);
    const double wide = static_cast<double>(candidate) * frame_width, high = 1.5 * lines * frame_height;
    const double off = std::max(wide / high, high / wide) * (1 + 0.12 * (candidate * lines - count));
    if (off >= best) continue;
    best = off;
    columns = candidate;
    rows = lines;
  }
  shrink = std::max({1, ceiling(columns * frame_width, largest_picture_side), ceiling(rows * frame_height, largest_picture_side)});
  width = ceiling(frame_width, shrink);
  height = ceiling(frame_height, shrink);
}

SmallFrame shrink_frame(const FrameBuffer& frame, int shrink) {
  SmallFrame small;
  small.width = ceiling(frame.width, shrink);
  small.height = ceiling(frame.height, shrink);
  small.colour.reserve(3 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const int right = std::min(frame.width, (x + 1) * shrink), bottom = std::min(frame.height, (y + 1) * shrink);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        double sum = 0;
        for (int row = y * shrink; row < bottom; ++row)
          for (int column = x * shrink; column < right; ++column)
            sum += std::clamp(
                frame
                    .colour[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(column)) +
                            channel],
                0.0, 1.0);
        const double mean = sum / ((right - x * shrink) * (bottom - y * shrink));
        small.colour.push_back(static_cast<std::uint8_t>(std::floor(mean * 255 + 0.5)));
      }
    }
  }
  return small;
}

FrameBuffer side_by_side(const PictureGrid& grid, const std::vector<LabelledFrame>& frames) {
  BUMP_ASSERT(static_cast<int>(frames.size()) <= grid.columns * grid.rows);
  const int scale = label_scale(grid, frames);
  const int line_height = (glyph_rows + 1) * scale;
  int widest = grid.width, lines = 0;
  for (const LabelledFrame& frame : frames) {
    lines = std::max(lines, static_cast<int>(frame.label.size()));
    for (const std::string& line : frame.label) widest = std::max(widest, label_width(line, scale));
  }

  FrameBuffer picture;
  picture.width = gap + grid.columns * (widest + gap);
  picture.height = gap + grid.rows * (lines * line_height + grid.height + gap);
  picture.colour.assign(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height), backdrop);
  for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
    const LabelledFrame& labelled = frames[static_cast<std::size_t>(i)];
    BUMP_ASSERT(labelled.frame.width == grid.width && labelled.frame.height == grid.height);
    const int left = gap + i % grid.columns * (widest + gap);
    int top = gap + i / grid.columns * (lines * line_height + grid.height + gap);
    for (std::size_t line = 0; line < labelled.label.size(); ++line)
      draw_label(picture, left, top + static_cast<int>(line) * line_height, labelled.label[line], scale);
    paste(labelled.frame, picture, left, top + lines * line_height);
  }
  return picture;
}

}  // namespace bump
