#include "retiming/refetch.h"

#include <algorithm>

#include "channels/token_runs.h"

namespace bump {

namespace {

bool same_unit(const TextureFetchConfig& a, const TextureFetchConfig& b) {
  return a.cache == b.cache && a.footprints_per_cycle == b.footprints_per_cycle && a.filter == b.filter;
}

bool same_unit(const LightMapFetchConfig& a, const LightMapFetchConfig& b) {
  return a.cache == b.cache && a.reads_per_cycle == b.reads_per_cycle;
}

/// Runs fetch(units) once for the distinct units of each size of line, and gives each of `wanted` its result by keep(index, result).
template <class Unit, class Fetch, class Keep>
void fetch_by_line(const std::vector<Unit>& wanted, const Fetch& fetch, const Keep& keep) {
  std::vector<bool> is_done(wanted.size(), false);
  for (std::size_t first = 0; first < wanted.size(); ++first) {
    if (is_done[first]) continue;
    std::vector<Unit> units;
    std::vector<std::pair<std::size_t, std::size_t>> places;  // of `wanted`, and of its unit among the distinct ones
    for (std::size_t i = first; i < wanted.size(); ++i) {
      if (wanted[i].cache.line_bytes != wanted[first].cache.line_bytes) continue;
      const auto known = std::find_if(units.begin(), units.end(), [&](const Unit& unit) { return same_unit(unit, wanted[i]); });
      places.emplace_back(i, known - units.begin());
      if (known == units.end()) units.push_back(wanted[i]);
      is_done[i] = true;
    }
    const auto results = fetch(units);
    for (const auto& [index, unit] : places) keep(index, results[unit]);
  }
}

}  // namespace

std::array<int, 8> FetchSettings::key() const {
  const CacheGeometry &texels = texture.cache, &words = light_maps.cache;
  return {texels.line_bytes, words.line_bytes,          texels.sets, texels.ways, texture.footprints_per_cycle, words.sets,
          words.ways,        light_maps.reads_per_cycle};
}

std::vector<FetchedTrace> refetch(const TimingTrace& trace, const LightMaps* maps, const std::vector<FetchSettings>& settings,
                                  const std::atomic<bool>* cancelled) {
  std::vector<FetchedTrace> fetched(settings.size());
  std::vector<TextureFetchConfig> texture_units;
  std::vector<LightMapFetchConfig> light_map_units;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    texture_units.push_back(settings[i].texture);
    if (maps) light_map_units.push_back(settings[i].light_maps);
    for (const traced::Index stream : {traced::vertex, traced::setup, traced::raster})
      fetched[i].trace.streams[stream] = trace.streams[stream];
  }
  fetch_by_line(
      texture_units, [&](const std::vector<TextureFetchConfig>& units) { return fetch_texels(trace.accesses, units, cancelled); },
      [&](std::size_t i, const FetchedTexels& result) {
        fetched[i].trace.streams[traced::texture] = result.stream;
        fetched[i].traffic.texture = result.counters;
      });
  fetch_by_line(
      light_map_units, [&](const std::vector<LightMapFetchConfig>& units) { return fetch_words(trace.accesses, *maps, units, cancelled); },
      [&](std::size_t i, const FetchedWords& result) {
        fetched[i].trace.streams[traced::light_map] = result.stream;
        fetched[i].traffic.light_maps = result.counters;
      });
  return fetched;
}

bool same_stream(const TokenStream& a, const TokenStream& b) {
  return a.tokens == b.tokens && std::equal(a.kinds.begin(), a.kinds.end(), b.kinds.begin(), b.kinds.end(), same_record) &&
         std::equal(a.runs.begin(), a.runs.end(), b.runs.begin(), b.runs.end(),
                    [](const TokenStream::Run& x, const TokenStream::Run& y) { return x.kind == y.kind && x.count == y.count; });
}

}  // namespace bump
