#pragma once
// Tags of a read-only cache (of textures, of light maps): set-associative, true LRU, in-order look-up, one tag array for all that it
// serves. Hit or miss depends on the order of addresses only, so this is pure state without time; the memory port (timing_graph.h) dates
// the misses.

#include <cstdint>
#include <string>
#include <vector>

namespace bump {

struct CacheGeometry {
  int sets = 32;  ///< power of two
  int ways = 4;
  int line_bytes = 64;  ///< power of two
  bool operator==(const CacheGeometry& o) const { return sets == o.sets && ways == o.ways && line_bytes == o.line_bytes; }
};

class TextureCache {
 public:
  /// `name` is what error messages call it.
  explicit TextureCache(const CacheGeometry& geometry, const std::string& name = "texture cache");
  /// Looks up the line that holds byte `address`, and fills it on a miss. True on a hit.
  bool access(std::uint64_t address) { return access_line(line_of(address)); }
  /// The same for a line: the most recently used one of a set is found at once, and nothing moves.
  bool access_line(std::uint64_t line) {
    std::uint64_t* first = &tags_[static_cast<std::size_t>(line & set_mask_) * ways_];
    return *first == line || move_to_front(first, line);
  }
  std::uint64_t line_of(std::uint64_t address) const { return address >> line_shift_; }
  /// log2 of the bytes of a line.
  int line_shift() const { return line_shift_; }

 private:
  bool move_to_front(std::uint64_t* first, std::uint64_t line);

  std::size_t ways_;
  std::uint64_t set_mask_;  ///< sets - 1
  int line_shift_ = 0;
  std::vector<std::uint64_t> tags_;  ///< sets x ways, most recently used first; ~0 is empty
};

}  // namespace bump
