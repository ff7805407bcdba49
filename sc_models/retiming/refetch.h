#pragma once
// A trace with addresses under other caches: which parameters of the fetch units that takes, and the records and counts that a run with
// them would have. No hardware.

#include <array>
#include <atomic>
#include <vector>

#include "retiming/cache_replay.h"
#include "retiming/timing_trace.h"

namespace bump {

/// What decides hits, misses and the intervals of fetches, besides what is read.
struct FetchSettings {
  TextureFetchConfig texture;
  LightMapFetchConfig light_maps;  ///< as declared for designs without light maps

  /// Settings with the same size of line are neighbours in this order.
  bool operator<(const FetchSettings& o) const { return key() < o.key(); }
  bool operator==(const FetchSettings& o) const { return key() == o.key(); }

 private:
  std::array<int, 8> key() const;
};

struct FetchTraffic {
  TextureCounters texture;
  std::vector<LightMapCounters> light_maps;  ///< by map; none for designs without. Words that were clipped are not known.
};

struct FetchedTrace {
  TimingTrace trace;  ///< the streams, nothing else
  FetchTraffic traffic;
};

/// `trace` has addresses; `maps` is null for designs without light maps. Results in the order of `settings`, which agree in the filter.
/// Throws Error(input) as the units do. When `cancelled` (may be null) is set, the results are incomplete.
std::vector<FetchedTrace> refetch(const TimingTrace& trace, const LightMaps* maps, const std::vector<FetchSettings>& settings,
                                  const std::atomic<bool>* cancelled);

/// Whether two streams hold the same records.
bool same_stream(const TokenStream& a, const TokenStream& b);

}  // namespace bump
