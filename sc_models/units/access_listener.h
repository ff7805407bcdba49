#pragma once
// Who wants to know what the fetch units read, before their caches look it up: texels and words of light maps by their coordinates, from
// which addresses follow for any line size. A recorder of traces is one (sc_models/retiming). Bookkeeping of the simulator, no hardware.

#include <array>
#include <cstdint>
#include <vector>

#include "memory/texture.h"
#include "units/tap_block.h"

namespace bump {

class AccessListener {
 public:
  AccessListener() = default;
  AccessListener(const AccessListener&) = delete;
  AccessListener& operator=(const AccessListener&) = delete;
  virtual ~AccessListener() = default;

  /// A texture in memory, as the hardware stores it: once each, in the order of their addresses, before anything is read.
  virtual void add_texture(const Texture& texture) = 0;
  /// A block of fragments in order: its taps in the colour texture and in the bump map, and which textures these are; -1 for none.
  virtual void add_texels(const std::array<int, 2>& textures, const std::array<TapBlock, 2>& taps, int lanes) = 0;
  /// A block of fragments in order: the entry of an object's light maps that each reads; its low `column_bits` bits are the column.
  virtual void add_words(int object, int column_bits, const std::vector<std::int64_t>& entries, int lanes) = 0;
};

}  // namespace bump
