#pragma once
// Where texels lie in memory: each level in tiles of 4 x 4 texels, tiles row by row, levels and textures one after another, each on a line
// boundary. With 4-byte texels and 64-byte lines a tile is a line. Addresses only; no time. Source: Hakura and Gupta, "The design and
// analysis of a cache architecture for texture mapping", ISCA 1997 (blocked representation).

#include <cstdint>
#include <vector>

#include "memory/texture.h"

namespace bump {

class TextureLayout {
 public:
  static constexpr int tile = 4;

  /// Places the texture at the first line boundary from `base` on.
  TextureLayout(const Texture& texture, std::uint64_t base, int line_bytes);

  /// Byte address of a texel; coordinates inside the level.
  std::uint64_t address(int level, int x, int y) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    const int tile_index = (y / tile) * at.tiles_across + x / tile, inside = (y % tile) * tile + x % tile;
    return at.base + (static_cast<std::uint64_t>(tile_index) * tile * tile + static_cast<std::uint64_t>(inside)) * bytes_per_texel_;
  }
  /// First byte behind the texture.
  std::uint64_t end() const { return end_; }

 private:
  struct Level {
    std::uint64_t base = 0;
    int tiles_across = 0;
  };
  std::vector<Level> levels_;
  std::uint64_t bytes_per_texel_ = 0, end_ = 0;
};

}  // namespace bump
