#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "schemes/scheme.h"
#include "testbench/experiments/compare.h"
#include "testbench/experiments/compare_picture.h"
#include "testbench/experiments/label.h"

namespace bump {

namespace {

FrameBuffer dark(int width, int height) {
  FrameBuffer picture;
  picture.width = width;
  picture.height = height;
  picture.colour.assign(3 * static_cast<std::size_t>(width * height), 0.0);
  return picture;
}

bool is_white(const FrameBuffer& picture, int x, int y) {
  const auto pixel = picture.colour.begin() + 3 * (y * picture.width + x);
  return std::all_of(pixel, pixel + 3, [](double value) { return value == 1; });
}

/// The raster of one letter as text, so that two can be told apart.
std::string raster_of(char letter) {
  FrameBuffer picture = dark(glyph_columns, glyph_rows);
  draw_label(picture, 0, 0, std::string(1, letter), 1);
  std::string dots;
  for (int y = 0; y < glyph_rows; ++y)
    for (int x = 0; x < glyph_columns; ++x) dots += is_white(picture, x, y) ? '#' : '.';
  return dots;
}

SmallFrame plain(int width, int height, std::uint8_t grey) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width * height), grey)};
}

}  // namespace

TEST_CASE("every letter that a label may need has a glyph of its own") {
  std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789BR().-_";
  std::set<std::string> rasters = {raster_of('?')};
  for (const char letter : letters) {
    INFO(letter);
    CHECK(rasters.insert(raster_of(letter)).second);
  }
  CHECK(raster_of(' ') == std::string(glyph_columns * glyph_rows, '.'));
  CHECK(raster_of('?') == raster_of('@'));
}

TEST_CASE("the label of every scheme can be drawn") {
  for (const Scheme* scheme : all_schemes())
    for (const char letter : marked_id(scheme->page()) + " 25.3 dB reference identical failed -") {
      INFO(scheme->page().id << ": " << letter);
      CHECK(has_glyph(letter));
    }
}

TEST_CASE("a label is as wide as it says, at every scale") {
  for (const int scale : {1, 2, 5}) {
    for (const std::string text : {"d", "dd", "lee2007_corrected (R)", "25.3 dB"}) {
      const int width = label_width(text, scale);
      FrameBuffer picture = dark(width + 40, 9 * scale + 40);
      draw_label(picture, 20, 20, text, scale);
      int left = picture.width, right = -1, top = picture.height, bottom = -1;
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          if (!is_white(picture, x, y)) continue;
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        }
      }
      CHECK(left >= 20);
      CHECK(right < 20 + width);
      CHECK(right >= 20 + width - scale);  // the last of these letters reaches the right edge
      CHECK(top == 20);
      CHECK(bottom < 20 + glyph_rows * scale);
    }
  }
  CHECK(label_width("", 3) == 0);
}

TEST_CASE("a label that does not fit is cut off at the edges") {
  for (const int left : {-7, -3, 0, 5}) {
    FrameBuffer picture = dark(8, 6);
    draw_label(picture, left, -2, "abc", 1);
    CHECK(picture.colour.size() == 3 * 8 * 6);
  }
}

TEST_CASE("every scheme's id can be written") {
  for (const Scheme* scheme : all_schemes())
    for (const char letter : scheme->page().id) CHECK(raster_of(letter) != raster_of('?'));
}

TEST_CASE("the grid has a place for every frame, no empty row, and no side beyond the limit") {
  for (int count = 1; count <= 30; ++count) {
    for (const auto& [width, height] : {std::pair{512, 512}, {1920, 1080}, {7, 900}, {4096, 4096}, {16384, 1}, {16384, 16384}}) {
      const PictureGrid grid(width, height, count);
      CHECK(grid.columns * grid.rows >= count);
      CHECK(grid.columns * (grid.rows - 1) < count);
      CHECK(grid.columns * width <= grid.shrink * largest_picture_side);
      CHECK(grid.rows * height <= grid.shrink * largest_picture_side);
      CHECK(grid.width >= 1);
      CHECK(grid.height >= 1);
      if (grid.shrink > 1) CHECK(std::max(grid.columns * width, grid.rows * height) > (grid.shrink - 1) * largest_picture_side);
    }
  }
}

TEST_CASE("a frame that is shrunk keeps its mean, and one that is not its pixels") {
  FrameBuffer frame = dark(6, 4);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) frame.colour[i] = static_cast<double>(i * 37 % 256) / 255;
  const SmallFrame same = shrink_frame(frame, 1);
  for (std::size_t i = 0; i < frame.colour.size(); ++i) CHECK(same.colour[i] == i * 37 % 256);
  const SmallFrame half = shrink_frame(frame, 2);
  CHECK(half.width == 3);
  CHECK(half.height == 2);
  const double mean = (frame.colour[0] + frame.colour[3] + frame.colour[18] + frame.colour[21]) / 4;
  CHECK(half.colour[0] == Approx(mean * 255).margin(0.5));
  const SmallFrame uneven = shrink_frame(frame, 4);  // the right column averages 2 x 4 pixels only
  CHECK(uneven.width == 2);
  CHECK(uneven.height == 1);
}

TEST_CASE("labels and frames stand side by side, also when a label is wider than its frame") {
  const std::vector<LabelledFrame> frames = {
      {{"reference"}, plain(20, 10, 51)}, {{"lee2007_corrected (R)", "33.4 dB"}, plain(20, 10, 102)}, {{"a"}, plain(20, 10, 153)}};
  const PictureGrid grid(20, 10, 3);
  const FrameBuffer picture = side_by_side(grid, frames);
  REQUIRE(picture.colour.size() == 3 * static_cast<std::size_t>(picture.width * picture.height));
  CHECK(picture.width > grid.columns * label_width("lee2007_corrected (R)", 1));
  for (const double grey : {0.2, 0.4, 0.6}) {
    INFO(grey);
    CHECK(std::count(picture.colour.begin(), picture.colour.end(), grey) == 3 * 20 * 10);
  }
  CHECK(std::count(picture.colour.begin(), picture.colour.end(), 1.0) > 3 * 150);  // letters
}

TEST_CASE("letters grow with the frames") {
  const auto white = [](int side) {
    const FrameBuffer picture = side_by_side(PictureGrid(side, side, 1), {{{"reference"}, plain(side, side, 0)}});
    return std::count(picture.colour.begin(), picture.colour.end(), 1.0);
  };
  CHECK(white(512) == 4 * white(64));
}

}  // namespace bump
