#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "testbench/reference/quality.h"

using namespace bump;

namespace {

/// A frame of one object on a plane that leans away to the right.
FrameBuffer frame(int width, int height, double colour) {
  FrameBuffer result;
  result.width = width;
  result.height = height;
  const auto pixels = static_cast<std::size_t>(width * height);
  result.colour.assign(3 * pixels, colour);
  result.object.assign(pixels, 0);
  result.depth.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) result.depth[i] = 0.5 + 0.01 * static_cast<double>(static_cast<int>(i) % width);
  return result;
}

}  // namespace

TEST_CASE("identical images have no error and an infinite signal-to-noise ratio") {
  const Quality quality = compare_frames(frame(8, 8, 0.3), frame(8, 8, 0.3));
  CHECK(std::isinf(quality.psnr_db));
  CHECK(quality.nmse == std::array<double, 3>{0, 0, 0});
  CHECK(quality.max_error == 0);
  CHECK(quality.pixels == 64);
  CHECK(quality.excluded == 0);
}

TEST_CASE("a uniform error has the measures that its definition gives") {
  const double wanted = GENERATE(0.2, 0.5, 1.0);
  const double error = GENERATE(-0.1, 0.001, 0.05);
  const Quality quality = compare_frames(frame(8, 8, wanted + error), frame(8, 8, wanted));
  CHECK(quality.psnr_db == Approx(-20 * std::log10(std::abs(error))));
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(quality.nmse[c] == Approx(error * error / (wanted * wanted)));
    CHECK(quality.rnmse[c] == Approx(std::abs(error) / wanted));
    CHECK(quality.pmse[c] == Approx(error * error));
    CHECK(quality.rpmse[c] == Approx(std::abs(error)));
  }
  CHECK(quality.max_error == Approx(255 * std::abs(error)));
  CHECK(quality.mean_error == Approx(255 * std::abs(error)));
}

TEST_CASE("channels are measured apart, and pooled in the signal-to-noise ratio") {
  FrameBuffer test = frame(2, 1, 0.5);
  test.colour[0] += 0.3;  // red of one pixel of two
  const Quality quality = compare_frames(test, frame(2, 1, 0.5));
  CHECK(quality.pmse[0] == Approx(0.045));
  CHECK(quality.nmse[0] == Approx(0.09 / 0.5));
  CHECK(quality.pmse[1] == 0);
  CHECK(quality.psnr_db == Approx(-10 * std::log10(0.09 / 6)));
  CHECK(quality.max_error == Approx(76.5));
  CHECK(quality.mean_error == Approx(76.5 / 6));
}

TEST_CASE("background counts neither as right nor as wrong") {
  FrameBuffer test = frame(4, 4, 0.25), reference = frame(4, 4, 0.5);
  for (FrameBuffer* image : {&test, &reference}) {
    for (std::size_t pixel = 0; pixel < 8; ++pixel) image->object[pixel] = -1;
  }
  for (std::size_t pixel = 0; pixel < 8; ++pixel) test.colour[3 * pixel] = reference.colour[3 * pixel];
  const Quality quality = compare_frames(test, reference);
  CHECK(quality.pixels == 8);
  CHECK(quality.pmse[0] == Approx(0.0625));
}

TEST_CASE("pixels that show another object or another part of it are left out and counted") {
  const FrameBuffer reference = frame(8, 8, 0.5);
  FrameBuffer test = reference;
  test.object[9] = -1;    // uncovered
  test.object[20] = 1;    // another object
  test.depth[30] += 0.2;  // another part, behind
  for (const std::size_t pixel : {9u, 20u, 30u}) test.colour[3 * pixel] = 1;
  const Quality quality = compare_frames(test, reference);
  CHECK(quality.excluded == 3);
  CHECK(quality.pixels == 61);
  CHECK(std::isinf(quality.psnr_db));
}

TEST_CASE("depths may differ by what a shift of less than half a pixel makes") {
  const FrameBuffer reference = frame(8, 8, 0.5);
  FrameBuffer test = reference;
  for (double& depth : test.depth) depth += 0.004;  // 0.4 pixels of this slope
  CHECK(compare_frames(test, reference).excluded == 0);
  for (double& depth : test.depth) depth += 0.004;
  CHECK(compare_frames(test, reference).excluded == 64);
}

TEST_CASE("frames without a common pixel have no measures") {
  FrameBuffer test = frame(4, 4, 0.5);
  for (auto& object : test.object) object = -1;
  const Quality quality = compare_frames(test, frame(4, 4, 0.5));
  CHECK(quality.pixels == 0);
  CHECK(quality.excluded == 16);
  CHECK(std::isnan(quality.psnr_db));
  CHECK(std::isnan(quality.nmse[0]));
  CHECK(std::isnan(quality.max_error));
}

TEST_CASE("a colour that is not a number never passes for a good picture") {
  FrameBuffer test = frame(4, 4, 0.5);
  test.colour[GENERATE(0u, 20u, 47u)] = std::nan("");
  const Quality quality = compare_frames(test, frame(4, 4, 0.5));
  CHECK(std::isnan(quality.psnr_db));
  CHECK(std::isnan(quality.max_error));
}

TEST_CASE("the error image grows from black over blue, red and yellow to white") {
  const FrameBuffer reference = frame(6, 1, 0);
  FrameBuffer test = reference;
  const double steps[5] = {0, 3, 15, 63, 255};
  for (std::size_t pixel = 0; pixel < 5; ++pixel) test.colour[3 * pixel + pixel % 3] = steps[pixel] / 255;
  test.object[5] = 1;
  const FrameBuffer image = error_image(test, reference);
  const double expected[6][3] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0.6, 0}};
  for (std::size_t pixel = 0; pixel < 6; ++pixel)
    for (std::size_t c = 0; c < 3; ++c) CHECK(image.colour[3 * pixel + c] == Approx(expected[pixel][c]).margin(1e-12));
}

TEST_CASE("pixels that are left out count as background of the test frame") {
  FrameBuffer test = frame(8, 8, 0.5), reference = frame(8, 8, 0.4);
  for (std::size_t pixel = 40; pixel < 64; ++pixel) reference.object[pixel] = -1;
  std::vector<std::uint8_t> left_out(64, 0);
  for (std::size_t pixel = 0; pixel < 64; pixel += 3) left_out[pixel] = 1;
  const Quality masked = compare_frames(test, reference, &left_out);
  for (std::size_t pixel = 0; pixel < 64; pixel += 3) test.object[pixel] = -1;
  const Quality removed = compare_frames(test, reference);
  CHECK(masked.pixels == removed.pixels);
  CHECK(masked.excluded == removed.excluded);
  CHECK(masked.psnr_db == removed.psnr_db);
}

TEST_CASE("a comparison judges every pixel as same_surface does, at the border of the frame and of objects too") {
  const int width = GENERATE(1, 2, 3, 7, 16), height = GENERATE(1, 2, 5);
  FrameBuffer reference = frame(width, height, 0.5), test = reference;
  unsigned state = 1;
  const auto random = [&](unsigned below) { return (state = state * 1664525u + 1013904223u) / 65536u % below; };
  for (int round = 0; round < 20; ++round) {
    for (std::size_t pixel = 0; pixel < reference.object.size(); ++pixel) {
      reference.object[pixel] = static_cast<std::int32_t>(random(3)) - 1;
      test.object[pixel] = random(4) == 0 ? static_cast<std::int32_t>(random(3)) - 1 : reference.object[pixel];
      reference.depth[pixel] = random(100) / 100.0;
      test.depth[pixel] = reference.depth[pixel] + (random(40) - 20.0) / 100;
    }
    std::int64_t same = 0, other = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto pixel = static_cast<std::size_t>(y * width + x);
        if (same_surface(test, reference, x, y))
          ++same;
        else if (test.object[pixel] >= 0 || reference.object[pixel] >= 0)
          ++other;
      }
    }
    const Quality quality = compare_frames(test, reference);
    REQUIRE(quality.pixels == same);
    REQUIRE(quality.excluded == other);
  }
}

TEST_CASE("threads do not change the error image") {
  FrameBuffer test = frame(40, 100, 0.5), reference = frame(40, 100, 0.4);
  for (std::size_t i = 0; i < test.colour.size(); ++i) test.colour[i] += 0.0001 * static_cast<double>(i % 977);
  CHECK(error_image(test, reference, 1).colour == error_image(test, reference, 4).colour);
}
