// The texture cache against a naive model of true LRU.

#include <algorithm>
#include <catch2/catch.hpp>
#include <list>
#include <random>
#include <vector>

#include "datapath/error.h"
#include "memory/texture_cache.h"

namespace bump {
namespace {

/// A list of lines per set, most recently used first.
class NaiveCache {
 public:
  explicit NaiveCache(const CacheGeometry& g) : geometry_(g), sets_(static_cast<std::size_t>(g.sets)) {}
  bool access(std::uint64_t address) {
    const std::uint64_t line = address / static_cast<std::uint64_t>(geometry_.line_bytes);
    std::list<std::uint64_t>& set = sets_[static_cast<std::size_t>(line) % sets_.size()];
    const bool hit = std::count(set.begin(), set.end(), line) > 0;
    set.remove(line);
    set.push_front(line);
    if (set.size() > static_cast<std::size_t>(geometry_.ways)) set.pop_back();
    return hit;
  }

 private:
  CacheGeometry geometry_;
  std::vector<std::list<std::uint64_t>> sets_;
};

/// Addresses with locality: a walk that now and then jumps back.
std::vector<std::uint64_t> walk(std::mt19937_64& random, std::size_t count, std::uint64_t range) {
  std::vector<std::uint64_t> addresses;
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    at = random() % 8 == 0 ? random() % range : (at + random() % 96) % range;
    addresses.push_back(at);
  }
  return addresses;
}

std::int64_t misses(const CacheGeometry& geometry, const std::vector<std::uint64_t>& addresses) {
  TextureCache cache(geometry);
  std::int64_t count = 0;
  for (const std::uint64_t address : addresses) count += cache.access(address) ? 0 : 1;
  return count;
}

TEST_CASE("the texture cache hits and misses like a list of lines per set in order of use") {
  std::mt19937_64 random(1);
  for (const int sets : {1, 2, 8, 64}) {
    for (const int ways : {1, 2, 3, 7}) {
      for (const int line_bytes : {1, 16, 64}) {
        const CacheGeometry geometry{sets, ways, line_bytes};
        TextureCache cache(geometry);
        NaiveCache naive(geometry);
        bool same = true;
        for (const std::uint64_t address : walk(random, 3000, 1 << 14)) same = same && cache.access(address) == naive.access(address);
        INFO(sets << " sets, " << ways << " ways, " << line_bytes << " bytes");
        CHECK(same);
      }
    }
  }
}

TEST_CASE("a further way never adds a miss to an LRU cache") {
  std::mt19937_64 random(2);
  const std::vector<std::uint64_t> addresses = walk(random, 20000, 1 << 13);
  std::int64_t before = misses({4, 1, 32}, addresses);
  for (int ways = 2; ways <= 12; ++ways) {
    const std::int64_t now = misses({4, ways, 32}, addresses);
    CHECK(now <= before);
    before = now;
  }
  CHECK(before < misses({4, 1, 32}, addresses));
}

TEST_CASE("a cache that holds everything misses once per line") {
  std::mt19937_64 random(3);
  std::vector<std::uint64_t> addresses = walk(random, 5000, 4096), lines;
  for (const std::uint64_t address : addresses) lines.push_back(address / 64);
  std::sort(lines.begin(), lines.end());
  const auto distinct = std::unique(lines.begin(), lines.end()) - lines.begin();
  CHECK(misses({16, 4, 64}, addresses) == distinct);
}

TEST_CASE("a cache whose sets or lines are no power of two is refused") {
  CHECK_THROWS_AS(TextureCache({3, 1, 64}), Error);
  CHECK_THROWS_AS(TextureCache({4, 1, 48}), Error);
  CHECK_THROWS_AS(TextureCache({4, 0, 64}), Error);
}

}  // namespace
}  // namespace bump
