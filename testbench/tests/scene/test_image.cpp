#include <cmath>
#include <limits>

#include "scene_bench.h"
#include "testbench/scene/image.h"

using namespace bump;
using namespace bump::test;

namespace {

Image load(const std::string& path) {
  return decode_image(path, read_file(path));
}

ErrorText error_loading(const std::string& path) {
  return error_of([&] { load(path); });
}

}  // namespace

TEST_CASE("row 0 of a picture is its bottom row, and integers scale to 1") {
  const TemporaryFolder folder;
  const Image image = load(folder.write_image("a.png", 2, 2, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}));
  REQUIRE(image.width == 2);
  REQUIRE(image.height == 2);
  REQUIRE(image.channels == 3);
  CHECK(image.bits == 8);
  CHECK(image.values == std::vector<double>{0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0});
}

TEST_CASE("16-bit and floating-point pictures keep their precision") {
  const TemporaryFolder folder;
  const Image deep = load(folder.write_image("a.png", 1, 1, 1, {12345.0f / 65535.0f}, 16));
  CHECK(deep.bits == 16);
  CHECK(deep.channels == 1);
  CHECK(deep.values[0] == 12345.0 / 65535.0);
  const auto suffix = GENERATE(as<std::string>(), ".exr", ".tif");
  const Image floating = load(folder.write_image("b" + suffix, 2, 1, 3, {0.125f, -2, 3, 1.5f, 0.25f, 1e-3f}, 32));
  CHECK(floating.bits == 32);
  CHECK(floating.values[1] == -2);
  CHECK(floating.values[5] == static_cast<double>(1e-3f));
}

TEST_CASE("alpha is dropped and never multiplied into the colours") {
  const TemporaryFolder folder;
  const Image colour = load(folder.write_image("a.png", 1, 1, 4, {1, 0.5f, 0.25f, 0}));
  REQUIRE(colour.channels == 3);
  CHECK(colour.values[0] == 1);
  CHECK(colour.values[1] == Approx(0.5).margin(0.003));
  const Image grey = load(folder.write_image("b.png", 1, 1, 2, {0.75f, 0.2f}));
  REQUIRE(grey.channels == 1);
  CHECK(grey.values[0] == Approx(0.75).margin(0.003));
}

TEST_CASE("content decides the format, not the name") {
  const TemporaryFolder folder;
  const std::string png = folder.write_image("a.png", 4, 4, 3, std::vector<float>(48, 0.5f));
  CHECK(load(folder.write("b.jpg", read_file(png))).width == 4);
}

TEST_CASE("files that are no pictures are refused") {
  const TemporaryFolder folder;
  CHECK(error_loading(folder.write("a.png", "this is a text, not a picture")).what.find("is not an image") != std::string::npos);
  CHECK(error_loading(folder.write("b.png", "x")).what.find("is not an image") != std::string::npos);
  CHECK(error_loading(folder.write("c.tga", "abc")).what.find("is truncated or damaged") != std::string::npos);
  CHECK(error_loading(folder.write("d.png", "\x89PNG\r\n\x1a\n")).what.find("is truncated or damaged") != std::string::npos);
}

TEST_CASE("a picture cut off anywhere is refused") {
  const TemporaryFolder folder;
  const auto suffix = GENERATE(as<std::string>(), ".png", ".jpg", ".tif", ".exr", ".bmp", ".tga", ".hdr", ".ppm");
  const bool floating = suffix == ".exr" || suffix == ".hdr";
  std::vector<float> noise;
  unsigned state = 1;
  for (int i = 0; i < 64 * 64 * 3; ++i) noise.push_back(static_cast<float>((state = state * 1664525u + 1013904223u) >> 16) / 65536.0f);
  const std::string whole = read_file(folder.write_image("whole" + suffix, 64, 64, 3, noise, floating ? 32 : 8));
  CHECK(decode_image("whole" + suffix, whole).width == 64);
  for (const double share : {0.02, 0.3, 0.6, 0.9}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    INFO(suffix << " cut to " << size << " of " << whole.size());
    const ErrorText error = error_loading(folder.write("cut" + suffix, whole.substr(0, size)));
    CHECK((error.what.find("is truncated or damaged") != std::string::npos || error.what.find("is not an image") != std::string::npos));
  }
}

TEST_CASE("a value that is not finite is refused with its place") {
  const TemporaryFolder folder;
  const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity());
  std::vector<float> values(12, 0.5f);
  values[7] = bad;  // second row from the top, first column
  const ErrorText error = error_loading(folder.write_image("a.exr", 2, 2, 3, values, 32));
  CHECK(error.what.find("is not finite") != std::string::npos);
  CHECK(error.why == "first at column 0, row 0 from the bottom");
}

TEST_CASE("a picture that claims to be huge is refused before it is read") {
  const TemporaryFolder folder;
  CHECK(error_loading(folder.write("a.ppm", "P6\n16385 1\n255\n")).what.find("is too big") != std::string::npos);
  CHECK(error_loading(folder.write("b.ppm", "P6\n16384 16384\n255\n")).what.find("is too big") != std::string::npos);
}

TEST_CASE("a picture without pixels is refused") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(load(folder.write("a.ppm", "P6\n0 0\n255\n")), Error);
}

TEST_CASE("errors name the place that refers to the picture") {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.png", "no picture");
  const ErrorText error = error_of([&] { decode_image(path, read_file(path), {"scene.toml", 12, 10}); });
  CHECK(to_string(error.where) == "scene.toml:12:10");
  CHECK(error.what.find(path) != std::string::npos);
}

TEST_CASE("normal maps are told from other pictures by their content") {
  Image image{4, 4, 3, 8, {}};
  for (int i = 0; i < 16; ++i) image.values.insert(image.values.end(), {0.5 + 0.02 * i, 0.6 - 0.02 * i, 0.93});
  CHECK(looks_like_normal_map(image));
  for (std::size_t i = 0; i < image.values.size(); i += 3) image.values[i + 2] = image.values[i];
  CHECK_FALSE(looks_like_normal_map(image));
  CHECK_FALSE(looks_like_normal_map({1, 1, 1, 8, {0.5}}));
  CHECK_FALSE(looks_like_normal_map({1, 1, 3, 8, {1, 1, 1}}));
  CHECK_FALSE(looks_like_normal_map({1, 1, 3, 8, {0.4, 0.2, 0.1}}));
}
