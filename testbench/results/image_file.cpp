#include "testbench/results/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "datapath/error.h"
#include "testbench/images/image_codec.h"

namespace bump {

namespace {

std::string encoded(const char* name, std::string bytes, const std::string& error) {
  if (!error.empty())
    throw Error(ErrorKind::internal, {std::string("cannot encode ") + name, {}, error, "check the installation of OpenImageIO"});
  return bytes;
}

}  // namespace

std::string encode_png(const FrameBuffer& frame) {
  std::vector<std::uint8_t> pixels(frame.colour.size());
  std::transform(frame.colour.begin(), frame.colour.end(), pixels.begin(),
                 [](double value) { return static_cast<std::uint8_t>(std::floor(std::clamp(value, 0.0, 1.0) * 255 + 0.5)); });
  std::string error;
  std::string bytes = image_codec().encode_png(frame.width, frame.height, pixels.data(), error);
  return encoded("frame.png", std::move(bytes), error);
}

std::string encode_exr(const FrameBuffer& frame) {
  const std::vector<float> pixels(frame.colour.begin(), frame.colour.end());
  std::string error;
  std::string bytes = image_codec().encode_exr(frame.width, frame.height, pixels.data(), error);
  return encoded("frame.exr", std::move(bytes), error);
}

}  // namespace bump
