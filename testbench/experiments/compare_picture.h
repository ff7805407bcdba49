#pragma once
// All pictures of a comparison side by side in a grid, each below its label. Frames that are too large for a page are shrunk by a whole
// number, averaged over squares of pixels. No model of hardware.

#include <cstdint>
#include <string>
#include <vector>

#include "units/frame_buffer.h"

namespace bump {

/// 8 bits a channel, rounded as encode_png() does; row 0 on top, three channels interleaved.
struct SmallFrame {
  int width = 0, height = 0;
  std::vector<std::uint8_t> colour;
};

/// How `count` frames of one size stand in a picture. Depends on nothing else, so that frames can be shrunk wherever they were drawn.
struct PictureGrid {
  PictureGrid(int frame_width, int frame_height, int count);

  int columns = 1, rows = 1;
  int shrink = 1;             ///< pixels of a frame, on each axis, to one of the picture
  int width = 0, height = 0;  ///< of a shrunk frame
};

/// The side that a picture may have, labels aside.
constexpr int largest_picture_side = 2400;

/// Averages squares of `shrink` x `shrink` pixels, what is left of them at the edges.
SmallFrame shrink_frame(const FrameBuffer& frame, int shrink);

struct LabelledFrame {
  std::vector<std::string> label;  ///< lines, in the letters of label.h
  SmallFrame frame;                ///< shrunk as the grid says
};

/// Row by row from the top left, in order.
FrameBuffer side_by_side(const PictureGrid& grid, const std::vector<LabelledFrame>& frames);

}  // namespace bump
