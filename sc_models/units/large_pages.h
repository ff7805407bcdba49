#pragma once
// Memory for whole frames: asks the system for large pages before the first touch, since a frame of ordinary pages costs more time in page
// faults and address translation than in being written. A hint only: contents and results do not depend on it. Bookkeeping of the
// simulator, no hardware.

#include <cstddef>
#include <vector>

namespace bump {

/// Asks for large pages where [begin, begin + bytes) fills any; does nothing on systems without them.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Room for `count` elements in large pages, as far as the vector has to move for it.
template <class T>
void reserve_large(std::vector<T>& vector, std::size_t count) {
  if (vector.capacity() >= count) return;
  vector.reserve(count);
  prefer_large_pages(vector.data() + vector.size(), (vector.capacity() - vector.size()) * sizeof(T));
}

}  // namespace bump
