#include "memory/texture_cache.h"

#include <algorithm>
#include <string>

#include "datapath/error.h"

namespace bump {

namespace {

constexpr std::uint64_t empty = ~std::uint64_t{0};

bool is_power_of_two(int value) {
  return value > 0 && (value & (value - 1)) == 0;
}

}  // namespace

TextureCache::TextureCache(const CacheGeometry& geometry, const std::string& name) : geometry_(geometry) {
  if (!is_power_of_two(geometry.sets))
    throw Error({name + " of " + std::to_string(geometry.sets) + " sets", {}, "the set is picked by address bits", "a power of two"});
  if (!is_power_of_two(geometry.line_bytes))
    throw Error({name + " lines of " + std::to_string(geometry.line_bytes) + " bytes",
                 {},
                 "the line is picked by address bits",
                 "a power of two"});
  if (geometry.ways < 1)
    throw Error({name + " of " + std::to_string(geometry.ways) + " ways", {}, "a set holds a line or more", "1 or more"});
  while ((1 << line_shift_) < geometry.line_bytes) ++line_shift_;
  tags_.assign(static_cast<std::size_t>(geometry.sets) * static_cast<std::size_t>(geometry.ways), empty);
}

std::uint64_t TextureCache::line_of(std::uint64_t address) const {
  return address >> line_shift_;
}

bool TextureCache::access(std::uint64_t address) {
  const std::uint64_t line = line_of(address);
  const auto set = static_cast<std::size_t>(line & static_cast<std::uint64_t>(geometry_.sets - 1));
  const auto first = tags_.begin() + static_cast<std::ptrdiff_t>(set * static_cast<std::size_t>(geometry_.ways));
  const auto end = first + geometry_.ways;
  if (*first == line) return true;
  const auto found = std::find(first + 1, end, line);
  const bool hit = found != end;
  // Move the line to the front: behind it stay the others in order of use, and on a miss the least recently used one falls out.
  std::move_backward(first, hit ? found : end - 1, hit ? found + 1 : end);
  *first = line;
  return hit;
}

}  // namespace bump
