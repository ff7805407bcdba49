#include "units/texture_layout.h"

namespace bump {

TextureLayout::TextureLayout(const Texture& texture, std::uint64_t base, int line_bytes)
    : bytes_per_texel_(static_cast<std::uint64_t>(texture.bytes_per_texel)), end_(base) {
  const auto line = static_cast<std::uint64_t>(line_bytes);
  for (const TextureLevel& level : texture.levels) {
    const unsigned across = (static_cast<unsigned>(level.width) + tile - 1) / tile,
                   down = (static_cast<unsigned>(level.height) + tile - 1) / tile;
    const std::uint64_t start = (end_ + line - 1) / line * line;
    levels_.push_back({start, across});
    end_ = start + std::uint64_t{across} * down * tile * tile * bytes_per_texel_;
  }
}

}  // namespace bump
