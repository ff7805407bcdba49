#pragma once
// Reads PNG files of every kind with libpng: grey, colour or palette, 1 to 16 bits, interlaced or not. Few bits become eight, palettes
// become colours, alpha and transparent colours are dropped; nothing else is done to the values (no gamma). No model of hardware. Source:
// PNG Specification, 2nd edition (ISO/IEC 15948).

#include <optional>
#include <string>

#include "datapath/error.h"

namespace bump {

struct Image;

/// Judged by the mark at the front.
bool is_png(const std::string& bytes);

/// Fills in `image`, or says what is wrong with the file `path`, whose content is `bytes`. `where` is the place to name. Flaws in parts
/// that no pixel depends on (texts, profiles) are passed over.
std::optional<ErrorText> decode_png(const std::string& path, const std::string& bytes, const Location& where, Image& image);

}  // namespace bump
