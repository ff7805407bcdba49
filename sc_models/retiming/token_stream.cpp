#include "retiming/token_stream.h"

#include <limits>

#include "channels/token_runs.h"

namespace bump {

std::uint32_t TokenStreamBuilder::kind_of(const TokenRecord& r) {
  const auto next = static_cast<std::uint32_t>(stream_.kinds.size());
  const auto [place, added] = kinds_.emplace(Key{r.interval, r.lead, r.misses, r.take, r.release, r.give}, next);
  if (added) stream_.kinds.push_back(r);
  return place->second;
}

void TokenStreamBuilder::append(const TokenRecord& record, std::uint32_t count) {
  if (count == 0) return;
  stream_.tokens += count;
  if (!stream_.runs.empty()) {
    TokenStream::Run& last = stream_.runs.back();
    if (count <= std::numeric_limits<std::uint32_t>::max() - last.count && same_record(stream_.kinds[last.kind], record)) {
      last.count += count;
      return;
    }
  }
  stream_.runs.push_back({kind_of(record), count});
}

}  // namespace bump
