#pragma once
// PNG files of rendered frames, written with libpng: 8 bits, red, green, blue. Every row is predicted from the one above (filter "up") and
// only runs are looked for (zlib's strategy "RLE", level 1): on rendered frames as quick as any setting of libpng's that makes files no
// larger. No model of hardware. Source: PNG Specification, 2nd edition (ISO/IEC 15948).

#include <string>

namespace bump {

/// `colour`: width * height * 3 values, row 0 on top. Clamped to [0, 1] and rounded to nearest (halves up).
std::string png_of(int width, int height, const double* colour);

}  // namespace bump
