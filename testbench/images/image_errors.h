#pragma once
// What is said of picture files that cannot be used, whichever library read them. No model of hardware.

#include <optional>
#include <string>

#include "datapath/error.h"
#include "testbench/scene/image.h"

namespace bump {

inline ErrorText damaged_image(const std::string& path, const Location& where, const std::string& why) {
  return {"texture '" + path + "' is truncated or damaged", where, why, "restore or re-export the file"};
}

/// Nothing if a picture of that size is allowed.
inline std::optional<ErrorText> too_big_image(const std::string& path, const Location& where, long width, long height, int channels) {
  if (width <= largest_image_side && height <= largest_image_side && width * height <= largest_image_texels && channels <= 16)
    return std::nullopt;
  return ErrorText{"texture '" + path + "' is too big", where,
                   std::to_string(width) + " x " + std::to_string(height) + " x " + std::to_string(channels) +
                       " channels; allowed 16384 on a side, 67108864 texels, 16 channels",
                   "scale it down"};
}

}  // namespace bump
