#include "memory/texture_cache.h"

#include <string>
#include <utility>

#include "datapath/error.h"

namespace bump {

namespace {

constexpr std::uint64_t empty = ~std::uint64_t{0};

bool is_power_of_two(int value) {
  return value > 0 && (value & (value - 1)) == 0;
}

}  // namespace

TextureCache::TextureCache(const CacheGeometry& geometry, const std::string& name)
    : ways_(static_cast<std::size_t>(geometry.ways)), set_mask_(static_cast<std::uint64_t>(geometry.sets - 1)) {
  if (!is_power_of_two(geometry.sets))
    throw Error({name + " of " + std::to_string(geometry.sets) + " sets", {}, "the set is picked by address bits", "a power of two"});
  if (!is_power_of_two(geometry.line_bytes))
    throw Error(
        {name + " lines of " + std::to_string(geometry.line_bytes) + " bytes", {}, "the line is picked by address bits", "a power of two"});
  if (geometry.ways < 1)
    throw Error({name + " of " + std::to_string(geometry.ways) + " ways", {}, "a set holds a line or more", "1 or more"});
  while ((1 << line_shift_) < geometry.line_bytes) ++line_shift_;
  tags_.assign(static_cast<std::size_t>(geometry.sets) * static_cast<std::size_t>(geometry.ways), empty);
}

bool TextureCache::move_to_front(std::uint64_t* first, std::uint64_t line) {
  // Behind the line stay the others in order of use; on a miss the least recently used one falls out.
  std::uint64_t before = *first;
  *first = line;
  for (std::size_t way = 1; way < ways_; ++way) {
    std::swap(before, first[way]);
    if (before == line) return true;
  }
  return false;
}

}  // namespace bump
