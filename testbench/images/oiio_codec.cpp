// The picture module: OpenImageIO behind ImageCodec.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "testbench/images/image_codec.h"
#include "testbench/images/image_errors.h"
#include "testbench/scene/image.h"

namespace bump {

namespace {

bool begins_with(const std::string& bytes, const char* magic, std::size_t length) {
  return bytes.size() >= length && std::memcmp(bytes.data(), magic, length) == 0;
}

bool has_suffix(const std::string& path, const std::string& suffix) {
  if (path.size() < suffix.size()) return false;
  return std::equal(suffix.begin(), suffix.end(), path.end() - static_cast<std::ptrdiff_t>(suffix.size()),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

/// The reader for the content, "" if nothing is recognised. Targa has no mark at its front, so that its name decides.
std::string format_of(const std::string& path, const std::string& bytes) {
  if (begins_with(bytes, "\xff\xd8\xff", 3)) return "jpeg";
  if (begins_with(bytes, "\x76\x2f\x31\x01", 4)) return "openexr";
  if (begins_with(bytes, "II*\0", 4) || begins_with(bytes, "MM\0*", 4)) return "tiff";
  if (begins_with(bytes, "BM", 2)) return "bmp";
  if (begins_with(bytes, "#?", 2)) return "hdr";
  if (bytes.size() > 2 && bytes[0] == 'P' && ((bytes[1] >= '1' && bytes[1] <= '6') || bytes[1] == 'f' || bytes[1] == 'F')) return "pnm";
  if (has_suffix(path, ".tga")) return "targa";
  return "";
}

/// libjpeg fills what is missing with grey and only warns: look for the end mark that belongs behind the last scan.
bool is_cut_jpeg(const std::string& bytes) {
  const auto scan = bytes.rfind("\xff\xda");
  const auto end = bytes.rfind("\xff\xd9");
  return scan == std::string::npos || end == std::string::npos || end < scan;
}

std::string one_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void configure_reader() {
  // One reader per file and no search for others: a damaged file must not wander through thirty parsers.
  static const bool configured =
      OIIO::attribute("try_all_readers", 0) && OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
  static_cast<void>(configured);
}

template <class Stored>
void copy_flipped(const std::vector<Stored>& pixels, std::size_t stored_channels, double scale, Image& image) {
  const std::size_t width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const std::size_t channels = static_cast<std::size_t>(image.channels);
  image.values.resize(width * height * channels);
  std::size_t out = 0;
  for (std::size_t row = height; row-- > 0;) {
    const Stored* in = &pixels[row * width * stored_channels];
    for (std::size_t x = 0; x < width; ++x, in += stored_channels) {
      for (std::size_t c = 0; c < channels; ++c) image.values[out++] = static_cast<double>(in[c]) / scale;
    }
  }
}

template <class Stored>
bool read_pixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, double scale, Image& image) {
  const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<Stored> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * channels);
  if (!input.read_image(0, 0, 0, spec.nchannels, type, pixels.data())) return false;
  copy_flipped(pixels, channels, scale, image);
  return true;
}

class OiioCodec : public ImageCodec {
 public:
  std::optional<ErrorText> decode(const std::string& path, const std::string& bytes, const Location& where, Image& image) const override;
};

std::optional<ErrorText> OiioCodec::decode(const std::string& path, const std::string& bytes, const Location& where, Image& image) const {
  const std::string named = "texture '" + path + "'";
  const auto damaged = [&](const std::string& why) { return damaged_image(path, where, why); };

  const std::string format = format_of(path, bytes);
  if (format.empty()) {
    return ErrorText{named + " is not an image", where, "its content is of no known format",
                     "PNG, JPEG, TIFF, OpenEXR, BMP, HDR, PNM, PFM or TGA"};
  }
  if (format == "jpeg" && is_cut_jpeg(bytes)) return damaged("the end mark of the JPEG stream is missing");

  configure_reader();
  OIIO::ImageSpec hints, spec;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::create(format);
  if (!input)
    return ErrorText{named + " cannot be read", where, "the reader for " + format + " is missing: " + one_line(OIIO::geterror()), ""};
  // The bytes that were hashed are the bytes that are decoded, wherever the reader can take them from memory.
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  if (input->supports("ioproxy")) input->set_ioproxy(&memory);
  if (!input->open(path, spec, hints)) return damaged(one_line(input->geterror()));
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return ErrorText{named + " has no pixels", where, "", "re-export the file"};
  if (spec.depth > 1 || spec.deep)
    return ErrorText{named + " is not a flat picture", where, "volumes and deep images have no place here", ""};
  if (auto wrong = too_big_image(path, where, spec.width, spec.height, spec.nchannels)) return wrong;

  image.width = spec.width;
  image.height = spec.height;
  image.channels = spec.nchannels >= 3 ? 3 : 1;
  bool complete = false;
  if (spec.format == OIIO::TypeDesc::UINT8) {
    complete = read_pixels<unsigned char>(*input, spec, OIIO::TypeDesc::UINT8, 255.0, image);
  } else if (spec.format == OIIO::TypeDesc::UINT16) {
    image.bits = 16;
    complete = read_pixels<unsigned short>(*input, spec, OIIO::TypeDesc::UINT16, 65535.0, image);
  } else {
    image.bits = 32;
    complete = read_pixels<float>(*input, spec, OIIO::TypeDesc::FLOAT, 1.0, image);
  }
  // The TIFF reader reports success and leaves an error behind when strips are missing.
  if (!complete || input->has_error()) return damaged(one_line(input->geterror()));
  const auto bad = std::find_if(image.values.begin(), image.values.end(), [](double value) { return !std::isfinite(value); });
  if (bad != image.values.end()) {
    const long texel = (bad - image.values.begin()) / image.channels;
    return ErrorText{
        named + " holds a value that is not finite", where,
        "first at column " + std::to_string(texel % image.width) + ", row " + std::to_string(texel / image.width) + " from the bottom",
        "re-export the file"};
  }
  return std::nullopt;
}

}  // namespace

}  // namespace bump

extern "C" const bump::ImageCodec* bump_image_codec() {
  static const bump::OiioCodec codec;
  return &codec;
}
