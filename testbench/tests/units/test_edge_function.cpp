// Exact coverage against a brute-force oracle that knows no fill rule: it asks whether a point a hair to the right of the pixel centre, and
// less than a hair below it, lies strictly inside.

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "units/edge_function.h"

namespace bump {
namespace {

constexpr int bits = 2, pixels = 32, grid = pixels << bits;

SetupTriangle triangle(const std::array<std::int64_t, 6>& at) {
  SetupTriangle t;
  for (std::size_t c = 0; c < 3; ++c) {
    t.x[c] = static_cast<double>(at[2 * c]) / (1 << bits);
    t.y[c] = static_cast<double>(at[2 * c + 1]) / (1 << bits);
  }
  return t;
}

bool strictly_inside(const std::array<std::int64_t, 6>& at, int x, int y) {
  // One grid step is 2^20 here; 2^12 to the right and 1 down cannot cross a line through two grid points that does not touch the centre.
  constexpr std::int64_t step = std::int64_t{1} << 20;
  const std::int64_t px = ((std::int64_t{x} << bits) + (1 << bits) / 2) * step + (1 << 12);
  const std::int64_t py = ((std::int64_t{y} << bits) + (1 << bits) / 2) * step + 1;
  int positive = 0, negative = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3;
    const std::int64_t ax = at[2 * c] * step, ay = at[2 * c + 1] * step, bx = at[2 * d] * step, by = at[2 * d + 1] * step;
    const std::int64_t side = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    positive += side > 0;
    negative += side < 0;
  }
  return positive == 3 || negative == 3;
}

std::int64_t area(const std::array<std::int64_t, 6>& p) {
  return (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
}

void cover(const std::array<std::int64_t, 6>& at, std::vector<int>& count) {
  if (area(at) == 0) return;
  const EdgeFunctions edges(triangle(at), bits);
  for (int y = 0; y < pixels; ++y) {
    const PixelSpan span = edges.span(y, 0, pixels - 1);
    for (int x = span.first; x <= span.last; ++x) ++count[static_cast<std::size_t>(y * pixels + x)];
  }
}

TEST_CASE("spans cover exactly the pixels whose centre, nudged right and down, lies inside") {
  std::mt19937 random(11);
  int covered = 0, wrong = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::array<std::int64_t, 6> at{};
    // A coarse grid for every other triangle: edges that run through pixel centres.
    for (auto& value : at) value = trial % 2 ? random() % (grid + 1) : 2 * (random() % (grid / 2 + 1));
    if (area(at) == 0) continue;
    std::vector<int> count(pixels * pixels, 0);
    cover(at, count);
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        const int seen = count[static_cast<std::size_t>(y * pixels + x)];
        covered += seen;
        wrong += seen != (strictly_inside(at, x, y) ? 1 : 0);
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(covered > 10000);
}

TEST_CASE("edge functions sum up to the area everywhere and the box holds the triangle") {
  std::mt19937 random(12);
  for (int trial = 0; trial < 500; ++trial) {
    std::array<std::int64_t, 6> at{};
    for (auto& value : at) value = static_cast<std::int64_t>(random() % (3 * grid)) - grid;
    if (area(at) == 0) continue;
    const EdgeFunctions edges(triangle(at), bits);
    const int x = static_cast<int>(random() % 200) - 100, y = static_cast<int>(random() % 200) - 100;
    REQUIRE(edges.at(0, x, y) + edges.at(1, x, y) + edges.at(2, x, y) == edges.area());
    const PixelSpan span = edges.span(y, -1000, 1000);
    if (span.first <= span.last) {
      REQUIRE((y >= edges.top() && y <= edges.bottom()));
      REQUIRE((span.first >= edges.left() && span.last <= edges.right()));
    }
  }
}

TEST_CASE("a fan around an inner point covers every pixel of its square exactly once") {
  std::mt19937 random(13);
  for (int trial = 0; trial < 400; ++trial) {
    // Corners and extra points on the sides of the whole frame, in order, around a random centre.
    std::vector<std::array<std::int64_t, 2>> ring;
    for (int side = 0; side < 4; ++side) {
      std::vector<std::int64_t> along{0};
      for (auto i = random() % 5; i > 0; --i) along.push_back(1 + random() % (grid - 1));
      std::sort(along.begin(), along.end());
      for (const std::int64_t s : along) {
        if (side == 0) ring.push_back({s, 0});
        if (side == 1) ring.push_back({grid, s});
        if (side == 2) ring.push_back({grid - s, grid});
        if (side == 3) ring.push_back({0, grid - s});
      }
    }
    const auto cx = static_cast<std::int64_t>(random() % (grid + 1)), cy = static_cast<std::int64_t>(random() % (grid + 1));
    std::vector<int> count(pixels * pixels, 0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto& a = ring[i];
      const auto& b = ring[(i + 1) % ring.size()];
      cover({cx, cy, a[0], a[1], b[0], b[1]}, count);
    }
    REQUIRE(std::count(count.begin(), count.end(), 1) == pixels * pixels);
  }
}

TEST_CASE("a grid with wildly displaced inner vertices covers every pixel exactly once") {
  std::mt19937 random(14);
  constexpr int cells = 4, cell = grid / cells;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<std::array<std::array<std::int64_t, 2>, cells + 1>, cells + 1> at{};
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const auto nudge = [&](bool border) { return border ? 0 : static_cast<std::int64_t>(random() % (cell / 2)) - cell / 4; };
        at[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = {i * cell + nudge(i % cells == 0), j * cell + nudge(j % cells == 0)};
      }
    }
    std::vector<int> count(pixels * pixels, 0);
    for (std::size_t j = 0; j < cells; ++j) {
      for (std::size_t i = 0; i < cells; ++i) {
        const auto &a = at[j][i], &b = at[j][i + 1], &c = at[j + 1][i + 1], &d = at[j + 1][i];
        cover({a[0], a[1], b[0], b[1], c[0], c[1]}, count);
        cover({a[0], a[1], c[0], c[1], d[0], d[1]}, count);
      }
    }
    REQUIRE(std::count(count.begin(), count.end(), 1) == pixels * pixels);
  }
}

}  // namespace
}  // namespace bump
