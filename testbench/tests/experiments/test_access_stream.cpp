// Streams of what fetch units read: what goes in comes out, and bytes that are no stream are refused.

#include <catch2/catch.hpp>
#include <random>

#include "datapath/error.h"
#include "retiming/access_recorder.h"

using namespace bump;

namespace {

std::int32_t between(std::mt19937_64& random, std::int32_t low, std::int32_t high) {
  return low + static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(high - low + 1));
}

constexpr std::int32_t side = 200;

/// Neighbours, mostly: small steps that repeat, now and then a leap, other textures, other levels.
std::vector<FragmentAccess> random_fragments(std::mt19937_64& random, std::size_t count) {
  std::vector<FragmentAccess> fragments;
  FragmentAccess now;
  const auto leap = [&] {
    for (std::size_t t = 0; t < 2; ++t) {
      now.texture[t] = t == 1 && random() % 3 == 0 ? -1 : between(random, 0, 2);
      now.levels[t] = now.texture[t] < 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(between(random, 1, 2));
    }
    for (Footprint& at : now.at)
      at = {between(random, 0, 2), between(random, 0, side - 1), between(random, 0, side - 1), static_cast<std::uint8_t>(random() % 4)};
  };
  leap();
  std::int32_t dx = 1, dy = 0;
  while (fragments.size() < count) {
    if (random() % 40 == 0) leap();
    if (random() % 7 == 0) {
      dx = between(random, -9, 9);
      dy = between(random, -1, 1);
    }
    for (Footprint& at : now.at) {
      at.x = (at.x + dx + side) % side;
      at.y = (at.y + dy + side) % side;
    }
    if (random() % 11 == 0) now.at[random() % 4].sides = static_cast<std::uint8_t>(random() % 4);
    for (std::size_t same = random() % 5 == 0 ? random() % 300 : 1; same > 0; --same) fragments.push_back(now);
  }
  return fragments;
}

AccessStream stream_of(const std::vector<FragmentAccess>& fragments) {
  AccessStreamBuilder builder;
  for (const FragmentAccess& fragment : fragments) builder.append(fragment);
  return builder.finish();
}

bool same_reads(const FragmentAccess& a, const FragmentAccess& b) {
  if (a.texture != b.texture || a.levels != b.levels) return false;
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t i = 0; i < a.levels[t]; ++i) {
      const Footprint &x = a.at[2 * t + i], &y = b.at[2 * t + i];
      if (x.level != y.level || x.x != y.x || x.y != y.y || x.sides != y.sides) return false;
    }
  }
  return true;
}

RecordedAccesses accesses_of(AccessStream texels) {
  RecordedAccesses accesses;
  for (int i = 0; i < 3; ++i) {
    accesses.textures.emplace_back();
    for (int level = 0; level < 3; ++level) {
      accesses.textures.back().levels.emplace_back();
      accesses.textures.back().levels.back().width = accesses.textures.back().levels.back().height = side;
    }
  }
  accesses.texels = std::move(texels);
  return accesses;
}

}  // namespace

TEST_CASE("a stream of accesses gives back what went in") {
  std::mt19937_64 random(11);
  for (int round = 0; round < 60; ++round) {
    INFO("round " << round);
    const std::vector<FragmentAccess> fragments = random_fragments(random, random() % 2000);
    const AccessStream stream = stream_of(fragments);
    REQUIRE(stream.fragments == static_cast<std::int64_t>(fragments.size()));
    CHECK_NOTHROW(check_accesses(accesses_of(stream)));
    std::size_t at = 0, wrong = 0;
    for (AccessReader reader(stream); reader.next();)
      for (std::uint64_t i = 0; i < reader.alike(); ++i, ++at)
        wrong += at < fragments.size() && same_reads(reader.access(), fragments[at]) ? 0U : 1U;
    CHECK(at == fragments.size());
    CHECK(wrong == 0);
  }
}

TEST_CASE("fragments in a row that read the same take a few bytes, and so do equal steps") {
  FragmentAccess access;
  access.texture = {0, 1};
  access.levels = {1, 1};
  std::vector<FragmentAccess> still(100000, access), steps;
  for (std::int32_t i = 0; i < 100000; ++i) {
    access.at[0].x = 3 * i;
    access.at[2].x = i;
    steps.push_back(access);
  }
  CHECK(stream_of(still).bytes.size() < 30);
  CHECK(stream_of(steps).bytes.size() < 40);
}

TEST_CASE("bytes that are no stream are refused, and never read behind their end") {
  std::mt19937_64 random(5);
  const AccessStream stream = stream_of(random_fragments(random, 400));
  const auto is_refused = [](const AccessStream& other) {
    try {
      check_accesses(accesses_of(other));
      return false;
    } catch (const Error&) {
      return true;
    }
  };
  for (std::size_t size = 0; size < stream.bytes.size(); ++size) {
    INFO(size);
    CHECK(is_refused({stream.fragments, stream.bytes.substr(0, size)}));
  }
  CHECK(is_refused({stream.fragments, stream.bytes + '\0'}));
  CHECK(is_refused({stream.fragments - 1, stream.bytes}));
  CHECK(is_refused({stream.fragments + 1, stream.bytes}));
  std::size_t refused = 0;
  for (int round = 0; round < 4000; ++round) {
    AccessStream other = stream;
    other.bytes[random() % other.bytes.size()] = static_cast<char>(random());
    refused += is_refused(other) ? 1U : 0U;
  }
  CHECK(refused > 500);  // another byte may be another stream
}

TEST_CASE("accesses that read what is not there are refused") {
  FragmentAccess access;
  access.texture = {0, -1};
  access.levels = {1, 0};
  SECTION("a texel on the right") {
    access.at[0].x = side;
  }
  SECTION("a texel below") {
    access.at[0].y = -1;
  }
  SECTION("a level") {
    access.at[0].level = 3;
  }
  SECTION("a texture") {
    access.texture[0] = 3;
  }
  SECTION("no texture") {
    access.levels[1] = 1;
  }
  SECTION("nothing") {
    access.levels[0] = 0;
  }
  CHECK_THROWS_WITH(check_accesses(accesses_of(stream_of({access}))), Catch::Contains("contradicts itself"));
}
