#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "sample_report.h"
#include "testbench/results/image_file.h"

using namespace bump;
using bump::made_up::Workspace;

namespace {

std::vector<float> read_back(const std::string& path, const std::string& bytes, int& width, int& height) {
  std::ofstream(path, std::ios::binary) << bytes;
  auto input = OIIO::ImageInput::open(path);
  REQUIRE(input);
  width = input->spec().width;
  height = input->spec().height;
  REQUIRE(input->spec().nchannels == 3);
  std::vector<float> pixels(static_cast<std::size_t>(width * height * 3));
  REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, pixels.data()));
  return pixels;
}

}  // namespace

TEST_CASE("a PNG holds every colour rounded to the nearest of 256 steps") {
  const Workspace work;
  FrameBuffer frame = made_up::frame(37, 5, 0);
  frame.colour[0] = -0.5;
  frame.colour[1] = 1.5;
  frame.colour[2] = 0.5 / 255 - 1e-9;
  frame.colour[3] = 0.5 / 255 + 1e-9;
  int width = 0, height = 0;
  const auto pixels = read_back(work / "frame.png", encode_png(frame), width, height);
  CHECK(width == 37);
  CHECK(height == 5);
  CHECK(pixels[0] == 0);
  CHECK(pixels[1] == 1);
  CHECK(pixels[2] == 0);
  CHECK(pixels[3] * 255 == Approx(1));
  for (std::size_t i = 4; i < pixels.size(); ++i) CHECK(pixels[i] * 255 == Approx(std::round(frame.colour[i] * 255)).margin(1e-4));
}

TEST_CASE("pictures of any size come back, with flat areas and with noise") {
  const Workspace work;
  std::uint32_t state = 7;
  for (const int width : {1, 2, 63, 700})
    for (const int height : {1, 16, 17, 400}) {
      FrameBuffer frame = made_up::frame(width, height, 0);
      // Whole 1/1024, which a float holds exactly.
      for (std::size_t i = 0; i < frame.colour.size(); ++i) {
        state = state * 1664525u + 1013904223u;
        frame.colour[i] = i % 600 < 300 ? 0.25 : static_cast<double>(state >> 22) / 1024;
      }
      INFO(width << " x " << height);
      int read_width = 0, read_height = 0;
      const auto exact = read_back(work / "frame.exr", encode_exr(frame), read_width, read_height);
      CHECK(read_width == width);
      CHECK(read_height == height);
      CHECK(std::equal(exact.begin(), exact.end(), frame.colour.begin(), frame.colour.end()));
      const auto rounded = read_back(work / "frame.png", encode_png(frame), read_width, read_height);
      CHECK(read_width == width);
      CHECK(read_height == height);
      CHECK(std::equal(rounded.begin(), rounded.end(), frame.colour.begin(), frame.colour.end(),
                       [](float step, double value) { return std::lround(step * 255) == std::lround(std::floor(value * 255 + 0.5)); }));
    }
}

TEST_CASE("an EXR holds floating-point numbers of any size, bit by bit") {
  const Workspace work;
  FrameBuffer frame = made_up::frame(64, 40, 0);
  std::uint32_t state = 3;
  for (double& value : frame.colour) {
    state = state * 1664525u + 1013904223u;
    const std::uint32_t bits = (state >> 8 | state << 24) & 0xbfffffff;  // finite
    float noise;
    std::memcpy(&noise, &bits, 4);
    value = noise;
  }
  int width = 0, height = 0;
  const auto pixels = read_back(work / "frame.exr", encode_exr(frame), width, height);
  CHECK(std::equal(pixels.begin(), pixels.end(), frame.colour.begin(), frame.colour.end()));
}

TEST_CASE("an EXR holds the colours unrounded, row 0 on top") {
  const Workspace work;
  const FrameBuffer frame = made_up::frame(9, 21, 0.001);
  int width = 0, height = 0;
  const auto pixels = read_back(work / "frame.exr", encode_exr(frame), width, height);
  CHECK(width == 9);
  CHECK(height == 21);
  for (std::size_t i = 0; i < pixels.size(); ++i) CHECK(pixels[i] == static_cast<float>(frame.colour[i]));
}

TEST_CASE("both files of a frame are what each is alone") {
  const FrameBuffer frame = made_up::frame(300, 200, 0.001);
  const FrameFiles files = encode_both(frame);
  CHECK(files.png == encode_png(frame));
  CHECK(files.exr == encode_exr(frame));
}

TEST_CASE("image files do not tell when they were written") {
  const std::string png = encode_png(made_up::frame(8, 8, 0)), exr = encode_exr(made_up::frame(8, 8, 0));
  CHECK(png.find("tIME") == std::string::npos);
  CHECK(png.find("DateTime") == std::string::npos);
  const auto date = exr.find("capDate");  // the format's own field, held at the beginning of time
  CHECK(date == exr.rfind("capDate"));
  CHECK(exr.find("1970:01:01 00:00:00") > date);
}
