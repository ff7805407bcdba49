#pragma once
// The accesses of a block of fragments to one texture, as a structure of arrays: which texels, which cache lines, which weights, and the
// filter over them. The same numbers, bit for bit, as texel_taps() and filter_texels() of memory/texture.h give one by one: found with
// vectors where all fragments read level 0, which is nearly always so, and by texel_taps() elsewhere. It exists because fetching texels is
// most of the work of a fragment outside the netlists. Part of the texture unit's time.

#include <array>
#include <cstdint>

#include "memory/texture.h"
#include "units/fragment_block.h"
#include "units/texture_layout.h"

namespace bump {

/// Where the lanes of a block read a texture, in planes. The derivatives are read by the trilinear filter only.
struct AccessLanes {
  const double *u = nullptr, *v = nullptr;
  const double *dudx = nullptr, *dvdx = nullptr, *dudy = nullptr, *dvdy = nullptr;
};

class TapBlock {
 public:
  static constexpr std::size_t most_taps = 8;
  using Words = std::array<std::int32_t, block_lanes>;
  using Lines = std::array<std::uint32_t, block_lanes>;

  /// Whether texels and lines of the texture can be numbered in 32 bits: others cannot be used here.
  static bool can_hold(const Texture& texture, const TextureLayout& layout);

  /// Finds the taps of lanes [0, lanes); the layout is that of the texture, with lines of 2^line_shift bytes.
  void find(const Texture& texture, const TextureLayout& layout, int line_shift, Filter filter, const AccessLanes& at, int lanes);
  /// The mean of every channel, into the planes out[channel]. `texture` is the one whose taps were found, or has its sizes and channels.
  void weigh(const Texture& texture, int lanes, Lanes* out) const;

  /// The most taps of any lane: 1, 4 or 8.
  std::size_t taps() const { return taps_; }
  /// Whether every lane has taps() of them, in level 0.
  bool is_uniform() const { return uniform_; }
  int taps_of(std::size_t lane) const { return uniform_ ? static_cast<int>(taps_) : count_[lane]; }
  /// The place of a tap's values in those of its level, (row * width + column) * channels.
  const Words& texel(std::size_t tap) const { return texel_[tap]; }
  int level(std::size_t tap, std::size_t lane) const { return uniform_ ? 0 : level_[tap / 4][lane]; }
  /// The line of a tap, counted from the first line of the texture. Lanes with fewer taps repeat the line of their first one.
  const Lines& line(std::size_t tap) const { return line_[tap]; }

 private:
  bool find_nearest(const Texture& texture, const AccessLanes& at, int lanes);
  bool find_bilinear(const Texture& texture, const AccessLanes& at, int lanes);
  void find_one_by_one(const Texture& texture, const TextureLayout& layout, int line_shift, Filter filter, const AccessLanes& at,
                       int lanes);
  void number_texels(const Texture& texture, const TextureLayout& layout, int line_shift, int lanes);
  void weigh_one_by_one(const Texture& texture, int lanes, Lanes* out) const;

  std::size_t taps_ = 1;
  bool uniform_ = true;
  std::array<Words, 2> column_{}, row_{};  ///< of level 0, left and right, below and above; nearest: the first only
  Lanes right_{}, high_{};                 ///< weights of the second column and row; the first have the rest
  std::array<Words, most_taps> texel_{};   ///< place of a tap's values in those of its level
  std::array<Lines, most_taps> line_{};
  std::array<Lanes, most_taps> weight_{};
  std::array<Words, 2> level_{};                   ///< of taps 0 to 3, and of the rest; where not uniform
  std::array<std::uint8_t, block_lanes> count_{};  ///< taps; where not uniform
};

}  // namespace bump
