#pragma once
// A bound on how far a polar scheme in fixed point can be from itself in double precision: what the self-check of a run promises. A
// measuring instrument, not hardware. Worst errors of a direction by cause, as root sum of squares; the bound takes them as if every pixel
// had them at once, so images are typically 20-30 dB better. For formulas that are continuous only.

#include "schemes/common/polar_settings.h"
#include "units/scene.h"

namespace bump {

struct PolarWidths {
  int table_bits = 8;         ///< address bits of a quarter turn of folded tables
  int word_bits = 16;         ///< bits of a table word
  int word_integer_bits = 8;  ///< of those, spent on the integer part of reciprocals; 0 without any
  int light_table_bits = 10;
};

/// dB; the inverse functions' address bits, arriving angles and texels come from the settings. At least 3, which any two images keep.
double polar_floor_db(const PolarSettings& settings, const PolarWidths& widths, const Material& material);

}  // namespace bump
