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
  static constexpr unsigned tile = 4;

  /// Places the texture at the first line boundary from `base` on.
  TextureLayout(const Texture& texture, std::uint64_t base, int line_bytes);

  /// Byte address of a texel; coordinates inside the level.
  std::uint64_t address(int level, int x, int y) const {
    const Level& at = levels_[static_cast<std::size_t>(level)];
    const auto column = static_cast<unsigned>(x), row = static_cast<unsigned>(y);
    const unsigned tile_index = (row / tile) * at.tiles_across + column / tile, inside = (row % tile) * tile + column % tile;
    return at.base + (std::uint64_t{tile_index} * tile * tile + inside) * bytes_per_texel_;
  }
  /// First byte of a level: on a line boundary.
  std::uint64_t start(int level) const { return levels_[static_cast<std::size_t>(level)].base; }
  /// Tiles in a row of tiles.
  unsigned tiles_across(int level) const { return levels_[static_cast<std::size_t>(level)].tiles_across; }
  /// First byte behind the texture.
  std::uint64_t end() const { return end_; }

 private:
  struct Level {
    std::uint64_t base = 0;
    unsigned tiles_across = 0;
  };
  std::vector<Level> levels_;
  std::uint64_t bytes_per_texel_ = 0, end_ = 0;
};

}  // namespace bump
