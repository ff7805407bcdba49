#include "datapath/rom_cache.h"

#include <map>
#include <mutex>

namespace bump {

namespace {

struct RomCache {
  std::mutex mutex;
  std::map<std::weak_ptr<const Table>, std::weak_ptr<const TableContents>, std::owner_less<>> roms;
};

RomCache& rom_cache() {
  static RomCache cache;  // weak references only: it decides what is shared, never what a result is
  return cache;
}

}  // namespace

std::shared_ptr<const TableContents> contents_of(const TablePtr& table) {
  RomCache& cache = rom_cache();
  const std::lock_guard<std::mutex> lock(cache.mutex);
  for (auto entry = cache.roms.begin(); entry != cache.roms.end();)
    entry = entry->second.expired() ? cache.roms.erase(entry) : std::next(entry);
  const auto found = cache.roms.find(std::weak_ptr<const Table>(table));
  if (found != cache.roms.end())
    if (auto contents = found->second.lock()) return contents;
  auto contents = std::make_shared<const TableContents>(tabulate(*table));
  cache.roms[table] = contents;
  return contents;
}

}  // namespace bump
