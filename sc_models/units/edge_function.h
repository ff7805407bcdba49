#pragma once
// Exact coverage of one raster triangle: three integer edge functions on the subpixel grid, pixel centres at .5, and the top-left rule, so
// that triangles that share an edge cover every pixel along it exactly once. The pixels of a row are found as a span by integer division
// instead of one test each; hardware tests several positions a cycle and needs no time for those outside. Source: Pineda, "A parallel
// algorithm for polygon rasterization", SIGGRAPH 1988; the fill rule is that of Direct3D and, for y downwards, of OpenGL implementations.

#include <array>
#include <cstdint>

#include "units/fragment_block.h"

namespace bump {

/// floor(a / b) for b > 0.
inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Pixels [first, last] of a row; empty when first > last.
struct PixelSpan {
  int first = 0, last = -1;
};

class EdgeFunctions {
 public:
  /// Corners must lie on the grid of `subpixel_bits` >= 1 and span an area. Either orientation.
  EdgeFunctions(const SetupTriangle& triangle, int subpixel_bits);

  /// Edge function opposite corner i at the centre of pixel (x, y): >= 0 inside; the three sum up to area().
  std::int64_t at(int i, int x, int y) const {
    const auto e = static_cast<std::size_t>(i);
    return origin_[e] + across_[e] * x + down_[e] * y;
  }
  /// Change from one pixel to the next on the right, and to the one below.
  std::int64_t across(int i) const { return across_[static_cast<std::size_t>(i)]; }
  std::int64_t down(int i) const { return down_[static_cast<std::size_t>(i)]; }
  /// Twice the triangle's area in squared subpixel steps, positive.
  std::int64_t area() const { return area_; }

  /// Covered pixels of row y among [left, right].
  PixelSpan span(int y, int left, int right) const;
  /// Rows and columns that may be covered.
  int top() const { return top_; }
  int bottom() const { return bottom_; }
  int left() const { return left_; }
  int right() const { return right_; }

 private:
  std::array<std::int64_t, 3> origin_{}, across_{}, down_{}, bias_{};
  std::int64_t area_ = 0;
  int top_ = 0, bottom_ = -1, left_ = 0, right_ = -1;
};

}  // namespace bump
