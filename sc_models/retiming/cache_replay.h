#pragma once
// What a run read (access_recorder.h) through caches of other geometry: the tags are those of the units themselves (texture_cache.h), fed
// with the addresses that the same layouts give for the size of line. Leaves the records that the units of such a run would leave, and
// what they would count. Bookkeeping of the simulator, no hardware. Source: see units/texture_fetch.h and units/light_map_fetch.h.

#include <atomic>
#include <vector>

#include "retiming/access_recorder.h"
#include "retiming/token_stream.h"
#include "schemes/scheme.h"
#include "units/counters.h"
#include "units/light_map_fetch.h"
#include "units/texture_fetch.h"

namespace bump {

struct FetchedTexels {
  TokenStream stream;
  TextureCounters counters;
};

struct FetchedWords {
  TokenStream stream;
  std::vector<LightMapCounters> counters;  ///< by map; words that were clipped are not known
};

/// Through several caches at once, which have the same size of line: addresses are worked out once. Results in the order of `units`. Throws
/// Error(input) if a texture is too large for the unit. When `cancelled` (may be null) is set, the results are incomplete.
std::vector<FetchedTexels> fetch_texels(const RecordedAccesses& accesses, const std::vector<TextureFetchConfig>& units,
                                        const std::atomic<bool>* cancelled);
/// `maps`: of the design. Throws Error(input) if a word does not fit into a line.
std::vector<FetchedWords> fetch_words(const RecordedAccesses& accesses, const LightMaps& maps,
                                      const std::vector<LightMapFetchConfig>& units, const std::atomic<bool>* cancelled);

}  // namespace bump
