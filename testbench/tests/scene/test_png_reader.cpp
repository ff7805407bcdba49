#include <OpenImageIO/imageio.h>
#include <png.h>

#include <cstdint>
#include <random>

#include "scene_bench.h"
#include "testbench/scene/image.h"

using namespace bump;
using namespace bump::test;

namespace {

struct Kind {
  int colour_type = PNG_COLOR_TYPE_GRAY, bits = 8;
  bool interlaced = false, transparent = false;
};

void append(png_structp png, png_bytep from, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(from), count);
}

/// Pixels are noise; palettes have as many colours as the bits can name.
std::string noise_png(const Kind& kind, int width, int height) {
  std::mt19937 random(7);
  const auto byte = [&random] { return static_cast<png_byte>(random() >> 24); };
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kind.bits, kind.colour_type,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<png_color> palette(std::size_t{1} << std::min(kind.bits, 8));
  for (png_color& colour : palette) colour = {byte(), byte(), byte()};
  if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  const std::vector<png_byte> alphas(palette.size(), 100);
  const png_color_16 clear{1, 1, 1, 1, 1};
  if (kind.transparent) png_set_tRNS(png, info, alphas.data(), static_cast<int>(alphas.size()), &clear);
  png_set_gAMA(png, info, 1.0);
  png_write_info(png, info);
  std::vector<png_byte> pixels(png_get_rowbytes(png, info) * static_cast<std::size_t>(height));
  for (png_byte& value : pixels) value = byte();
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y) rows.push_back(&pixels[png_get_rowbytes(png, info) * static_cast<std::size_t>(y)]);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  const auto add = [&kinds](int colour_type, std::initializer_list<int> depths, bool may_be_transparent) {
    for (const int bits : depths)
      for (const bool interlaced : {false, true})
        for (const bool transparent : {false, true})
          if (!transparent || may_be_transparent) kinds.push_back({colour_type, bits, interlaced, transparent});
  };
  add(PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}, true);
  add(PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}, true);
  add(PNG_COLOR_TYPE_RGB, {8, 16}, true);
  add(PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}, false);
  add(PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}, false);
  return kinds;
}

/// As OpenImageIO reads it: what is behind the colours dropped, row 0 at the bottom.
Image read_by_openimageio(const std::string& path) {
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path, &hints);
  REQUIRE(input);
  const OIIO::ImageSpec spec = input->spec();
  Image image{spec.width, spec.height, spec.nchannels >= 3 ? 3 : 1, spec.format == OIIO::TypeDesc::UINT16 ? 16 : 8, {}};
  const auto stored = static_cast<std::size_t>(spec.nchannels), width = static_cast<std::size_t>(spec.width);
  std::vector<std::uint16_t> pixels(width * static_cast<std::size_t>(spec.height) * stored);
  // Bytes arrive as 16 bits with the same byte twice.
  REQUIRE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT16, pixels.data()));
  for (std::size_t y = static_cast<std::size_t>(spec.height); y-- > 0;)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
        const int value = pixels[(y * width + x) * stored + c];
        image.values.push_back(image.bits == 16 ? value / 65535.0 : (value / 257) / 255.0);
      }
  return image;
}

}  // namespace

TEST_CASE("a PNG of any kind is read as OpenImageIO reads it") {
  const TemporaryFolder folder;
  for (const Kind& kind : all_kinds())
    for (const int side : {1, 2, 7, 37}) {
      const std::string bytes = noise_png(kind, side, side + 1);
      const std::string path = folder.write("a.png", bytes);
      INFO("colour type " << kind.colour_type << ", " << kind.bits << " bits, interlaced " << kind.interlaced << ", transparent "
                          << kind.transparent << ", " << side << " x " << side + 1);
      const Image read = decode_image(path, bytes), expected = read_by_openimageio(path);
      CHECK(read.width == expected.width);
      CHECK(read.height == expected.height);
      CHECK(read.channels == expected.channels);
      CHECK(read.bits == expected.bits);
      CHECK(read.values == expected.values);
    }
}

TEST_CASE("a PNG with a flaw is refused, or its pixels do not depend on it") {
  const Kind kind = GENERATE(Kind{PNG_COLOR_TYPE_RGB, 8, false, false}, Kind{PNG_COLOR_TYPE_PALETTE, 4, true, true});
  const std::string whole = noise_png(kind, 9, 7);
  const Image sound = decode_image("a.png", whole);
  int refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const int bit : {0, 4, 5}) {
      std::string flawed = whole;
      flawed[i] = static_cast<char>(flawed[i] ^ (1 << bit));
      try {
        const Image read = decode_image("a.png", flawed);
        CHECK(read.values == sound.values);
      } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::input);
        ++refused;
      }
    }
  CHECK(refused > static_cast<int>(whole.size()));
}

TEST_CASE("a PNG is refused wherever it ends too early") {
  const std::string whole = noise_png({PNG_COLOR_TYPE_RGB, 8, false, false}, 9, 7);
  for (std::size_t size = 8; size < whole.size(); ++size) {
    const ErrorText error = error_of([&] { decode_image("a.png", whole.substr(0, size)); });
    CHECK(error.what == "texture 'a.png' is truncated or damaged");
    CHECK(error.why == "the file ends too early");
  }
}

TEST_CASE("a PNG that is too big is refused, however big it says to be") {
  const int width = GENERATE(16385, 1000001);
  const ErrorText error = error_of([&] { decode_image("a.png", noise_png({PNG_COLOR_TYPE_GRAY, 1, false, false}, width, 1)); });
  CHECK(error.what.find("is too big") != std::string::npos);
  CHECK(error.why.find(std::to_string(width) + " x 1 x 1 channels") == 0);
}
