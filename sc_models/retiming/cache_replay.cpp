#include "retiming/cache_replay.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// Runs of accesses between two looks at whether the work is still wanted.
constexpr int patience = 1 << 14;

bool is_set(const std::atomic<bool>* flag) {
  return flag != nullptr && *flag;
}

/// The distinct lines of a fragment, in the order in which they are looked up.
struct Lines {
  static constexpr std::size_t most = 2 * TapBlock::most_taps;
  std::array<std::uint64_t, most> line{};
  std::size_t count = 0;
  int taps = 0, footprints = 0;

  void add(std::size_t first, std::uint64_t next) {
    for (std::size_t i = count; i-- > first;)
      if (line[i] == next) return;
    line[count++] = next;
  }
  bool operator==(const Lines& o) const {
    return count == o.count && taps == o.taps && footprints == o.footprints &&
           std::equal(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(count), o.line.begin());
  }
};

class LineFinder {
 public:
  LineFinder(const std::vector<Texture>& textures, const TextureFetchConfig& unit) : shift_(TextureCache(unit.cache).line_shift()) {
    std::uint64_t base = 0;
    for (const Texture& texture : textures) {
      places_.push_back(
          {texture, TextureFetch::layout_of(texture, base, unit.cache.line_bytes), unit.filter == Filter::nearest || !texture.filterable});
      base = places_.back().layout.end();
    }
  }

  void find(const FragmentAccess& access, Lines& lines) const {
    lines.count = 0;
    lines.taps = lines.footprints = 0;
    for (std::size_t t = 0; t < 2; ++t) {
      const std::size_t first = lines.count;  // textures do not share lines
      for (std::size_t i = 0; i < access.levels[t]; ++i)
        add_footprint(places_[static_cast<std::size_t>(access.texture[t])], access.at[2 * t + i], first, lines);
    }
  }

 private:
  struct Place {
    const Texture& texture;
    TextureLayout layout;
    bool is_lone;  ///< a footprint is one texel
  };

  void add_footprint(const Place& place, const Footprint& at, std::size_t first, Lines& lines) const {
    const auto line_of = [&](int x, int y) { return place.layout.address(at.level, x, y) >> shift_; };
    ++lines.footprints;
    const std::uint64_t lowest = line_of(at.x, at.y);
    lines.add(first, lowest);
    if (place.is_lone) {
      ++lines.taps;
      return;
    }
    lines.taps += 4;
    const TextureLevel& level = place.texture.levels[static_cast<std::size_t>(at.level)];
    const int right = next_texel(at.x, level.width, place.texture.wrap_u, (at.sides & 1U) != 0),
              above = next_texel(at.y, level.height, place.texture.wrap_v, (at.sides & 2U) != 0);
    const std::uint64_t highest = line_of(right, above);
    // Addresses grow with columns and rows: the other two lie between.
    if (highest == lowest && right >= at.x && above >= at.y) return;
    lines.add(first, line_of(right, at.y));
    lines.add(first, line_of(at.x, above));
    lines.add(first, highest);
  }

  int shift_;
  std::vector<Place> places_;
};

/// One cache and what it leaves.
struct TexelCache {
  TextureFetchConfig unit;
  TextureCache cache;
  TokenStreamBuilder records;
  TextureCounters counters;

  explicit TexelCache(const TextureFetchConfig& config) : unit(config), cache(config.cache) {}

  int misses_of(const Lines& lines) {
    int misses = 0;
    for (std::size_t i = 0; i < lines.count; ++i) misses += cache.access_line(lines.line[i]) ? 0 : 1;
    return misses;
  }

  void look_up(const Lines& lines, std::uint64_t fragments) {
    TokenRecord record;
    record.interval = static_cast<std::uint32_t>((lines.footprints + unit.footprints_per_cycle - 1) / unit.footprints_per_cycle);
    counters.reads += static_cast<std::int64_t>(fragments) * lines.taps;
    counters.accesses += static_cast<std::int64_t>(fragments * lines.count);
    // Fragments that read the same lines find them all, unless a set may have lost one of them on the way.
    const bool stay = lines.count <= static_cast<std::size_t>(unit.cache.ways);
    for (std::uint64_t fragment = 0; fragment < (stay ? 1 : fragments); ++fragment) {
      const int misses = misses_of(lines);
      counters.misses += misses;
      record.misses = static_cast<std::uint16_t>(misses);
      records.append(record);
    }
    if (!stay) return;
    record.misses = 0;
    for (std::uint64_t left = fragments - 1; left > 0;) {
      const std::uint64_t some = std::min<std::uint64_t>(left, 1U << 31);
      records.append(record, static_cast<std::uint32_t>(some));
      left -= some;
    }
  }

  FetchedTexels finish() {
    counters.hits = counters.accesses - counters.misses;
    counters.bytes = counters.misses * unit.cache.line_bytes;
    return {records.stream(), counters};
  }
};

/// One cache of light-map words and what it leaves.
struct WordCache {
  LightMapFetchConfig unit;
  TextureCache cache;
  TokenStreamBuilder records;
  std::vector<LightMapCounters> counters;

  WordCache(const LightMapFetchConfig& config, std::size_t maps) : unit(config), cache(config.cache, "light-map cache"), counters(maps) {}

  void look_up(const std::vector<std::uint64_t>& lines, std::uint64_t fragments) {
    TokenRecord record;
    record.interval = static_cast<std::uint32_t>((static_cast<int>(lines.size()) + unit.reads_per_cycle - 1) / unit.reads_per_cycle);
    const bool stay = lines.size() <= static_cast<std::size_t>(unit.cache.ways);
    for (LightMapCounters& counted : counters) counted.reads += static_cast<std::int64_t>(fragments);
    for (std::uint64_t fragment = 0; fragment < (stay ? 1 : fragments); ++fragment) {
      record.misses = 0;
      for (std::size_t map = 0; map < lines.size(); ++map) {
        if (cache.access_line(lines[map])) continue;
        ++counters[map].misses;
        ++record.misses;
      }
      records.append(record);
    }
    if (!stay) return;
    record.misses = 0;
    for (std::uint64_t fragment = 1; fragment < fragments; ++fragment) records.append(record);
  }

  FetchedWords finish() {
    for (LightMapCounters& counted : counters) {
      counted.hits = counted.reads - counted.misses;
      counted.bytes = counted.misses * unit.cache.line_bytes;
    }
    return {records.stream(), counters};
  }
};

template <class Cache>
auto finished(std::vector<Cache>& caches) {
  std::vector<decltype(caches.front().finish())> results;
  for (Cache& cache : caches) results.push_back(cache.finish());
  return results;
}

}  // namespace

std::vector<FetchedTexels> fetch_texels(const RecordedAccesses& accesses, const std::vector<TextureFetchConfig>& units,
                                        const std::atomic<bool>* cancelled) {
  BUMP_ASSERT(!units.empty());
  std::vector<TexelCache> caches;
  for (const TextureFetchConfig& unit : units) {
    BUMP_ASSERT(unit.cache.line_bytes == units.front().cache.line_bytes && unit.filter == units.front().filter);
    caches.emplace_back(unit);
  }
  const LineFinder finder(accesses.textures, units.front());
  Lines lines, next;
  std::uint64_t fragments = 0;
  const auto look_up = [&] {
    if (fragments == 0) return;
    for (TexelCache& cache : caches) cache.look_up(lines, fragments);
  };
  AccessReader reader(accesses.texels);
  for (int looks = 0; reader.next(); ++looks) {
    if (looks % patience == 0 && is_set(cancelled)) break;
    finder.find(reader.access(), next);
    if (fragments > 0 && next == lines) {
      fragments += reader.alike();
      continue;
    }
    look_up();
    std::swap(lines, next);
    fragments = reader.alike();
  }
  look_up();
  return finished(caches);
}

std::vector<FetchedWords> fetch_words(const RecordedAccesses& accesses, const LightMaps& maps,
                                      const std::vector<LightMapFetchConfig>& units, const std::atomic<bool>* cancelled) {
  BUMP_ASSERT(!units.empty());
  std::vector<WordCache> caches;
  for (const LightMapFetchConfig& unit : units) {
    BUMP_ASSERT(unit.cache.line_bytes == units.front().cache.line_bytes);
    caches.emplace_back(unit, maps.maps.size());
  }
  const LightMapLayout layout = LightMapFetch::layout_of(maps, units.front().cache.line_bytes);
  const int shift = caches.front().cache.line_shift();
  std::vector<std::uint64_t> lines(maps.maps.size());
  AccessReader reader(accesses.words);
  for (int looks = 0; reader.next(); ++looks) {
    if (looks % patience == 0 && is_set(cancelled)) break;
    const FragmentAccess& access = reader.access();
    const std::int64_t entry = std::int64_t{access.at[0].y} << layout.column_bits() | access.at[0].x;
    for (std::size_t map = 0; map < lines.size(); ++map)
      lines[map] = layout.address(access.texture[0], static_cast<int>(map), entry) >> shift;
    for (WordCache& cache : caches) cache.look_up(lines, reader.alike());
  }
  return finished(caches);
}

}  // namespace bump
