#include "testbench/results/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "datapath/error.h"

namespace bump {

namespace {

/// OpenImageIO writes the current time into an EXR that has no date of its own.
constexpr const char* no_date = "1970:01:01 00:00:00";

std::string encode(const std::string& name, OIIO::ImageSpec spec, OIIO::TypeDesc type, const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(name, &memory);
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorKind::internal, {"cannot encode " + name, {}, why, "check the installation of OpenImageIO"});
  };
  if (!output) fail(OIIO::geterror());
  if (!output->open(name, spec) || !output->write_image(type, pixels) || !output->close()) fail(output->geterror());
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string encode_png(const FrameBuffer& frame) {
  std::vector<std::uint8_t> pixels(frame.colour.size());
  std::transform(frame.colour.begin(), frame.colour.end(), pixels.begin(),
                 [](double value) { return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255 + 0.5)); });
  OIIO::ImageSpec spec(frame.width, frame.height, 3, OIIO::TypeDesc::UINT8);
  return encode("frame.png", spec, OIIO::TypeDesc::UINT8, pixels.data());
}

std::string encode_exr(const FrameBuffer& frame) {
  const std::vector<float> pixels(frame.colour.begin(), frame.colour.end());
  OIIO::ImageSpec spec(frame.width, frame.height, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", no_date);
  return encode("frame.exr", spec, OIIO::TypeDesc::FLOAT, pixels.data());
}

}  // namespace bump
