#include "datapath/slot_plan.h"

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

std::vector<int> SlotPlan::assign(const std::function<int(int)>& kind) {
  std::vector<std::size_t> last_read(held_.size(), 0);
  for (std::size_t s = 0; s < steps_.size(); ++s)
    for (const int node : steps_[s].read) last_read[static_cast<std::size_t>(node)] = s;
  std::vector<int> slots(held_.size(), -1);
  std::vector<std::vector<int>> free;
  const auto release = [&](int node, std::size_t step) {
    const auto i = static_cast<std::size_t>(node);
    if (held_[i] || last_read[i] > step || slots[i] < 0) return;
    std::vector<int>& pool = free[static_cast<std::size_t>(kind(node))];
    if (std::find(pool.begin(), pool.end(), slots[i]) == pool.end()) pool.push_back(slots[i]);
  };
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    for (const int node : steps_[s].made) {
      const auto pool = static_cast<std::size_t>(kind(node));
      if (free.size() <= pool) free.resize(pool + 1);
      if (sizes_.size() <= pool) sizes_.resize(pool + 1, 0);
      int& slot = slots[static_cast<std::size_t>(node)];
      if (free[pool].empty()) {
        slot = sizes_[pool]++;
      } else {
        slot = free[pool].back();  // the one that was in use last is in the cache
        free[pool].pop_back();
      }
    }
    for (const int node : steps_[s].read) {
      BUMP_ASSERT(slots[static_cast<std::size_t>(node)] >= 0);
      release(node, s);
    }
    for (const int node : steps_[s].made) release(node, s);  // what nobody reads
  }
  return slots;
}

}  // namespace bump
