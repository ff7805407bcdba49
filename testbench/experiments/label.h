#pragma once
// Text in a picture, from a built-in raster of 5 x 9 pixels (two of them below the line): no font files, the same bytes everywhere.
// Lower-case letters, digits, and what figures in decibels need; any other character is a frame. No model of hardware.

#include <string_view>

#include "units/frame_buffer.h"

namespace bump {

constexpr int glyph_columns = 5, glyph_rows = 9;  ///< of a letter at scale 1; one empty column stands between two letters

/// Pixels from the left edge of the first letter to the right edge of the last.
int label_width(std::string_view text, int scale);

/// False for a character that is drawn as a frame.
bool has_glyph(char letter);

/// White on whatever is there, `scale` (1 or more) pixels to a dot, with its top left corner at (left, top); clipped at the picture's
/// edges.
void draw_label(FrameBuffer& picture, int left, int top, std::string_view text, int scale);

}  // namespace bump
