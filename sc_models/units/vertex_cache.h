#pragma once
// The post-transform vertex cache: the last `entries` vertices transformed, first in, first out, by index. It only decides which vertices
// are transformed again; the look-up is part of the vertex processor's time. Source: Hoppe, "Optimization of mesh locality for transparent
// vertex caching", SIGGRAPH 1999 (FIFO replacement).

#include <cstdint>
#include <vector>

namespace bump {

class VertexCache {
 public:
  /// `entries` >= 0, 0 for no cache; `vertices`: indices are below it.
  VertexCache(int entries, std::size_t vertices) : entries_(entries), inserted_(vertices, never) {}

  /// True if the vertex is there; otherwise it is put in, and the oldest entry leaves a full cache.
  bool look_up(std::uint32_t vertex) {
    std::int64_t& when = inserted_[vertex];
    if (when != never && count_ - when <= entries_) return true;
    when = count_++;
    return false;
  }

 private:
  static constexpr std::int64_t never = -1;
  std::int64_t entries_, count_ = 0;    ///< insertions so far
  std::vector<std::int64_t> inserted_;  ///< per vertex: how many insertions came before its last one
};

}  // namespace bump
