#pragma once
// Frames as image files, encoded in memory so that every byte that reaches the disk goes through one checked write. The same frame gives
// the same bytes: no host names, and the only date is a constant.

#include <string>

#include "units/frame_buffer.h"

namespace bump {

/// 8 bits a channel, colours clamped to [0, 1] and rounded to nearest (halves up).
std::string encode_png(const FrameBuffer& frame);

/// 32-bit floating point, colours as they are.
std::string encode_exr(const FrameBuffer& frame);

struct FrameFiles {
  std::string png, exr;
};

/// Both, in two threads where the process has two cores.
FrameFiles encode_both(const FrameBuffer& frame);

}  // namespace bump
