#pragma once
// Pictures as stored: values in display units without any linearisation, grey or red-green-blue, row 0 at the bottom as in texture.h.
// Alpha is dropped, and never multiplied into the colours (a normal map that keeps its heights in alpha would be ruined). Formats: PNG,
// JPEG, TIFF, OpenEXR, BMP, Radiance HDR, PNM, PFM, Targa, recognised by their content rather than by their names.

#include <string>
#include <vector>

#include "datapath/error.h"

namespace bump {

struct Image {
  int width = 0, height = 0;
  int channels = 0;            ///< 1 or 3
  int bits = 8;                ///< of a stored channel: 8, 16, or 32 (floating point of any size)
  std::vector<double> values;  ///< row-major, row 0 at the bottom, channels interleaved; integers are scaled to [0, 1]
};

constexpr int largest_image_side = 16384;
constexpr long largest_image_texels = 1L << 26;

/// Reads `bytes`, the content of the file `path`. `from` is the place that refers to it. Throws Error(input) if it is no picture, truncated
/// or damaged, has no pixels, more than 16384 on a side or 2^26 in all, or a value that is not finite.
Image decode_image(const std::string& path, const std::string& bytes, const Location& from = {});

/// Red, green and blue are equal everywhere, or there is only one channel.
bool is_grey(const Image& image);

/// Judged by content: most texels are unit vectors coded as colours, pointing outwards on average.
bool looks_like_normal_map(const Image& image);

}  // namespace bump
