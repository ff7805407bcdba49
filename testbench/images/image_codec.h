#pragma once
// Reading and writing of picture files, which OpenImageIO does, behind an interface that is loaded when the first picture is needed: the
// library brings some 250 others with it, and a command that touches no picture must not wait for them. The module is `bumpsim_images.so`,
// beside the program. No exceptions cross its border. No model of hardware.

#include <optional>
#include <string>

#include "datapath/error.h"

namespace bump {

/// A picture as stored: row-major, row 0 at the bottom, channels interleaved; see testbench/scene/image.h.
struct Image;

class ImageCodec {
 public:
  virtual ~ImageCodec() = default;
  /// Fills in `image`, or says what is wrong with the file. `where` is the place to name.
  virtual std::optional<ErrorText> decode(const std::string& path, const std::string& bytes, const Location& where, Image& image) const = 0;
  /// Three channels, row 0 on top. `error` is set and nothing returned if the encoder fails.
  virtual std::string encode_png(int width, int height, const unsigned char* pixels, std::string& error) const = 0;
  virtual std::string encode_exr(int width, int height, const float* pixels, std::string& error) const = 0;
};

/// Loads the module at the first call. Throws Error(internal) if it is missing.
const ImageCodec& image_codec();

}  // namespace bump
