#pragma once
// Listens to the fetch units of a run and keeps what they read as streams. Bookkeeping of the simulator, no hardware.

#include <vector>

#include "retiming/access_stream.h"
#include "units/access_listener.h"

namespace bump {

/// What a run read, from which addresses, hits and misses follow for any cache.
struct RecordedAccesses {
  std::vector<Texture> textures;  ///< in the order of their addresses; sizes, wrap modes and width of a texel, without texels and names
  AccessStream texels;
  AccessStream words;  ///< of light maps; empty for designs without

  bool empty() const { return texels.fragments == 0 && textures.empty(); }
};

/// Column or row beside `at` in a texture of `size` texels, as the second side of a footprint.
inline std::int32_t next_texel(std::int32_t at, std::int32_t size, WrapMode wrap, bool is_same) {
  if (is_same || (wrap == WrapMode::clamp && at + 1 >= size)) return at;
  return at + 1 < size ? at + 1 : 0;
}

/// Throws Error(internal) naming what contradicts itself: textures, levels or texels that are not there.
void check_accesses(const RecordedAccesses& accesses);

class AccessRecorder : public AccessListener {
 public:
  void add_texture(const Texture& texture) override;
  void add_texels(const std::array<int, 2>& textures, const std::array<TapBlock, 2>& taps, int lanes) override;
  void add_words(int object, int column_bits, const std::vector<std::int64_t>& entries, int lanes) override;

  /// Once, when the run is over.
  RecordedAccesses finish();

 private:
  /// The footprint of taps [first, first + taps) of a lane, one or four.
  Footprint footprint(const Texture& texture, const TapBlock& taps, std::size_t first, std::size_t lane, bool is_lone) const;

  std::vector<Texture> textures_;
  AccessStreamBuilder texels_, words_;
};

}  // namespace bump
