#include "testbench/scene/image.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "testbench/images/image_codec.h"
#include "testbench/images/png_reader.h"

namespace bump {

Image decode_image(const std::string& path, const std::string& bytes, const Location& from) {
  Image image;
  const Location where = from.file.empty() ? Location{path, 0, 0} : from;
  const std::optional<ErrorText> wrong =
      is_png(bytes) ? decode_png(path, bytes, where, image) : image_codec().decode(path, bytes, where, image);
  if (wrong) throw Error(*wrong);
  return image;
}

bool is_grey(const Image& image) {
  if (image.channels == 1) return true;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    if (image.values[i] != image.values[i + 1] || image.values[i] != image.values[i + 2]) return false;
  }
  return true;
}

bool looks_like_normal_map(const Image& image) {
  if (image.channels != 3 || is_grey(image)) return false;
  std::size_t unit = 0;
  const std::size_t texels = image.values.size() / 3;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const double x = 2 * image.values[i] - 1, y = 2 * image.values[i + 1] - 1, z = 2 * image.values[i + 2] - 1;
    const double squared = x * x + y * y + z * z;
    if (z > 0 && squared > 0.64 && squared < 1.44) ++unit;
  }
  return unit * 10 >= texels * 9;
}

}  // namespace bump
