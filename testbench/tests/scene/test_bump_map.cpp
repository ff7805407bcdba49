#include <cmath>

#include "scene_bench.h"
#include "testbench/scene/bump_map.h"

using namespace bump;
using namespace bump::test;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int side = 64;

/// A wave with `across` and `up` periods over the picture, 0 to 1.
double wave(double x, double y, int across, int up) {
  return 0.5 + 0.5 * std::sin(2 * pi * (across * x + up * y) / side);
}

Image wave_heights(int across, int up) {
  Image image{side, side, 1, 32, {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) image.values.push_back(wave(x + 0.5, y + 0.5, across, up));
  }
  return image;
}

glm::dvec3 normal_at(const Texture& normals, std::size_t level, int x, int y) {
  const auto& image = normals.levels[level];
  const double* n = &image.texels[static_cast<std::size_t>(3 * (y * image.width + x))];
  return glm::dvec3(n[0], n[1], n[2]);
}

Image coded(const Texture& normals, bool green_down, double length = 1) {
  const auto& level = normals.levels[0];
  Image image{level.width, level.height, 3, 32, {}};
  for (std::size_t i = 0; i < level.texels.size(); ++i) {
    const double sign = green_down && i % 3 == 1 ? -1 : 1;
    image.values.push_back(0.5 + 0.5 * sign * length * level.texels[i]);
  }
  return image;
}

Texture relief() {
  std::vector<std::string> warnings;
  Image image = wave_heights(2, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] += wave_heights(1, -2).values[i];
  return height_texture(image, "relief", 4, {}, {}, warnings);
}

}  // namespace

TEST_CASE("normals of a known relief are those of its slopes") {
  std::vector<std::string> warnings;
  for (const auto& [across, up] : {std::pair<int, int>{1, 0}, {0, 1}, {2, -1}, {3, 2}}) {
    const double scale = 5;
    const Texture normals = normals_from_heights(height_texture(wave_heights(across, up), "h", scale, {}, {}, warnings));
    for (int y = 0; y < side; y += 5) {
      for (int x = 0; x < side; x += 5) {
        // Central differences of a wave are its slope times sin(step)/step.
        const double phase = 2 * pi * (across * (x + 0.5) + up * (y + 0.5)) / side;
        const double dx = scale * 0.5 * std::cos(phase) * std::sin(2 * pi * across / side);
        const double dy = scale * 0.5 * std::cos(phase) * std::sin(2 * pi * up / side);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(-dx, -dy, 1));
        CHECK(glm::distance(normal_at(normals, 0, x, y), expected) < 1e-12);
      }
    }
  }
  CHECK(warnings.empty());
}

TEST_CASE("wrap modes decide the slope at the border") {
  std::vector<std::string> warnings;
  Image ramp{4, 1, 1, 32, {0, 1, 2, 3}};
  const Texture clamped = normals_from_heights(height_texture(ramp, "h", 1, {WrapMode::clamp, WrapMode::clamp}, {}, warnings));
  const Texture repeated = normals_from_heights(height_texture(ramp, "h", 1, {}, {}, warnings));
  CHECK(glm::distance(normal_at(clamped, 0, 0, 0), glm::normalize(glm::dvec3(-0.5, 0, 1))) < 1e-12);
  CHECK(glm::distance(normal_at(clamped, 0, 1, 0), glm::normalize(glm::dvec3(-1, 0, 1))) < 1e-12);
  CHECK(glm::distance(normal_at(repeated, 0, 0, 0), glm::normalize(glm::dvec3(1, 0, 1))) < 1e-12);
}

TEST_CASE("normals are unit on every level") {
  const Texture normals = normals_from_heights(relief());
  REQUIRE(normals.levels.size() == 7);
  for (const auto& level : normals.levels) {
    for (std::size_t i = 0; i < level.texels.size(); i += 3) {
      const glm::dvec3 n(level.texels[i], level.texels[i + 1], level.texels[i + 2]);
      REQUIRE(glm::length(n) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("a normal map gives back the normals it was coded from, green up or down") {
  const Texture expected = normals_from_heights(relief());
  for (const bool green_down : {false, true}) {
    std::vector<std::string> warnings;
    const Texture normals = normals_from_map(coded(expected, green_down), "n", green_down, {}, {}, warnings);
    CHECK(warnings.empty());
    double worst = 0;
    for (std::size_t i = 0; i < normals.levels[0].texels.size(); ++i) {
      worst = std::max(worst, std::abs(normals.levels[0].texels[i] - expected.levels[0].texels[i]));
    }
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("the wrong green direction is noticed from the slopes alone") {
  std::vector<std::string> warnings;
  const Texture expected = normals_from_heights(relief());
  const Texture wrong = normals_from_map(coded(expected, true), "n", false, {}, {}, warnings);
  CHECK(warns_of(warnings, "try green = \"down\""));
  CHECK(integrability(expected) > 0.9);
  CHECK(integrability(wrong) == Approx(-integrability(expected)));
  CHECK(green_correlation(expected, relief()) > 0.9);
  CHECK(green_correlation(wrong, relief()) < -0.9);
  CHECK(integrability(flat_normals()) == 0);
}

TEST_CASE("normals of the wrong length are made unit and reported") {
  std::vector<std::string> warnings;
  const Texture expected = normals_from_heights(relief());
  const Texture normals = normals_from_map(coded(expected, false, 0.7), "short.png", false, {}, {}, warnings);
  CHECK(warns_of(warnings, "'short.png': normals have mean length 0.7, standard deviation 0"));
  CHECK(glm::distance(normal_at(normals, 0, 5, 9), normal_at(expected, 0, 5, 9)) < 1e-12);
}

TEST_CASE("normals without length become flat, those that point inwards stay, both are counted") {
  std::vector<std::string> warnings;
  Image image{2, 2, 3, 8, {0.5, 0.5, 1, 0.5, 0.5, 0.5, 127.0 / 255, 128.0 / 255, 128.0 / 255, 0.5, 0.75, 0.1}};
  const Texture normals = normals_from_map(image, "odd", false, {}, {}, warnings);
  CHECK(warns_of(warnings, "2 normals without length became flat"));
  CHECK(warns_of(warnings, "1 normals point into the surface"));
  CHECK(normal_at(normals, 0, 1, 0) == glm::dvec3(0, 0, 1));
  CHECK(normal_at(normals, 0, 0, 1) == glm::dvec3(0, 0, 1));
  CHECK(normal_at(normals, 0, 1, 1).z < 0);
}

TEST_CASE("height and normal maps that were mixed up are refused") {
  std::vector<std::string> warnings;
  const Location from{"scene.toml", 4, 2};
  CHECK(error_of([&] { normals_from_map(wave_heights(1, 1), "h", false, {}, from, warnings); }).what ==
        "'h' is grey and cannot be a normal map");
  const Image map = coded(normals_from_heights(relief()), false);
  CHECK(error_of([&] { height_texture(map, "n", 1, {}, from, warnings); }).what == "'n' looks like a normal map");
}

TEST_CASE("a coloured height map is averaged with a warning") {
  std::vector<std::string> warnings;
  const Texture heights = height_texture({1, 1, 3, 8, {0.9, 0.3, 0.0}}, "h", 10, {}, {}, warnings);
  CHECK(warns_of(warnings, "height map in colour"));
  CHECK(heights.levels[0].texels[0] == Approx(4));
}

TEST_CASE("colours are used as stored, grey is repeated, and what lies outside 0 to 1 is clamped with a warning") {
  std::vector<std::string> warnings;
  CHECK(colour_texture({1, 1, 3, 8, {0.2, 0.4, 0.6}}, "c", {}, warnings).levels[0].texels == std::vector<double>{0.2, 0.4, 0.6});
  CHECK(colour_texture({1, 1, 1, 8, {0.3}}, "g", {}, warnings).levels[0].texels == std::vector<double>{0.3, 0.3, 0.3});
  CHECK(warnings.empty());
  CHECK(colour_texture({1, 1, 3, 32, {-1, 0.5, 7}}, "o", {}, warnings).levels[0].texels == std::vector<double>{0, 0.5, 1});
  CHECK(warns_of(warnings, "2 colour values outside [0, 1]"));
}

TEST_CASE("the built-in relief tiles") {
  const Texture studs = stud_heights();
  const auto& level = studs.levels[0];
  const std::size_t width = static_cast<std::size_t>(level.width);
  double highest = 0;
  for (std::size_t i = 0; i < width; ++i) {
    CHECK(level.texels[i] == level.texels[(width - 1) * width + i]);
    CHECK(level.texels[i * width] == level.texels[i * width + width - 1]);
  }
  for (const double value : level.texels) highest = std::max(highest, value);
  CHECK(highest == Approx(6).epsilon(0.01));
}
