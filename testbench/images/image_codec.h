#pragma once
// Reading of all picture formats but PNG, which OpenImageIO does, behind an interface that is loaded when it is first needed: the library
// brings some 250 others with it, and loading takes longer than simulating a small frame. PNG, which most textures are, goes to libpng
// alone (png_reader.h), and pictures are written with libpng and OpenEXR (png_writer.h, exr_writer.h). The module is `bumpsim_images.so`,
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
};

/// Loads the module at the first call. Throws Error(internal) if it is missing.
const ImageCodec& image_codec();

}  // namespace bump
