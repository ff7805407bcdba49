#pragma once
// What a fetch unit reads, fragment by fragment, for keeping: footprints by their coordinates, so that addresses follow for any size of
// line. Fragments are neighbours, so a fragment is kept as its step from the one before: most steps are of a few kinds and take a byte, or
// less where they repeat. Bookkeeping of the simulator, no hardware.
//
// As bytes: for each run of equal steps a number, 2 x code + (1 if it is longer than one), what the code asks for, and the length of a
// longer run less two. Numbers as in byte_numbers.h, moves with their sign folded.
//   code 0      levels of both textures (two bits each) + 16 if textures follow; these, each plus one; for each footprint its moves in
//               level, x and y, and its sides
//   code 1      levels and sides are those of the fragment before: for each footprint its moves in x and y
//   code 2      the same, and the second texture's footprints move as the first's: moves of the first texture's only
//   code 3 + k  the k-th distinct short step of the stream so far, steps of code 0 to 2 with moves of -8 to 7 being short while fewer than
//               4096 are known; not those where textures follow

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bump {

/// A texel, or a square of two by two texels: its left column and lower row. `sides` says where the other column and row are not the next:
/// bit 0, both columns are the same; bit 1, both rows are.
struct Footprint {
  std::int32_t level = 0, x = 0, y = 0;
  std::uint8_t sides = 0;
};

/// Reads of a fragment. Of light maps: one footprint of level 0 in the first place, the object in place of the texture.
struct FragmentAccess {
  std::array<std::int32_t, 2> texture{-1, -1};  ///< -1: none
  std::array<std::uint8_t, 2> levels{};         ///< footprints, 0 to 2
  std::array<Footprint, 4> at{};                ///< two places for each texture; those that are not in use keep what they held last
};

struct AccessStream {
  std::int64_t fragments = 0;  ///< 0: nothing was recorded
  std::string bytes;
};

/// A step from one fragment to the next.
struct AccessStep {
  struct Move {
    std::int32_t level = 0, x = 0, y = 0;
    std::uint8_t sides = 0;
  };
  std::array<std::uint8_t, 2> levels{};
  std::array<Move, 4> moves{};  ///< those in use; others are zero
};

/// Makes a stream of fragments as they come.
class AccessStreamBuilder {
 public:
  /// Of places that are not in use, nothing is read.
  void append(const FragmentAccess& access);
  /// All that was appended; nothing may follow.
  AccessStream finish();

 private:
  using Key = std::array<std::int32_t, 18>;
  static Key key_of(const AccessStep& step);
  void write_run();
  std::uint64_t code_of() const;
  void write_step(std::uint64_t code);

  AccessStream stream_;
  FragmentAccess last_;
  AccessStep step_;  ///< of the run that is not yet written
  Key key_{};
  std::uint64_t run_ = 0;
  bool textures_change_ = false;                 ///< with step_
  std::array<std::uint8_t, 2> levels_before_{};  ///< in front of step_
  std::array<std::uint8_t, 4> sides_before_{};
  std::map<Key, std::uint64_t> kinds_;
};

/// Walks over a stream, which must outlive it.
class AccessReader {
 public:
  explicit AccessReader(const AccessStream& stream) : stream_(&stream) {}
  /// Goes to the next fragment that reads something else, or the next run of them; false behind the last. Throws Error(internal) if the
  /// bytes are no stream.
  bool next();
  const FragmentAccess& access() const { return access_; }
  /// How many fragments in a row read just that.
  std::uint64_t alike() const { return alike_; }

 private:
  struct Kind {
    AccessStep step;
    bool still = false;  ///< moves nothing
  };
  std::uint64_t number();
  std::int32_t move();
  void read_step();
  void read_textures(std::uint64_t flags);
  void apply();

  const AccessStream* stream_;
  std::size_t at_ = 0;
  std::int64_t done_ = 0;  ///< fragments
  FragmentAccess access_;
  std::uint64_t left_ = 0, alike_ = 0;
  Kind kind_;
  std::vector<Kind> kinds_;
};

}  // namespace bump
