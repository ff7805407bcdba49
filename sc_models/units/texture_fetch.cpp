#include "units/texture_fetch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "datapath/invariant.h"
#include "memory/level_of_detail.h"
#include "units/bump_map.h"

namespace bump {

namespace {

Filter filter_called(const std::string& name) {
  if (name == "nearest") return Filter::nearest;
  return name == "bilinear" ? Filter::bilinear : Filter::trilinear;
}

}  // namespace

void TextureFetchConfig::declare(Parameters& p) {
  p.choice("texture_fetch.filter", "bilinear", {"nearest", "bilinear", "trilinear"},
           "filter of colour texels, and of bump maps that may be filtered");
  p.integer("texture_fetch.footprints_per_cycle", 2, 1, 64, "footprints", "2 x 2 texel footprints that the cache serves each cycle");
  p.integer("texture_fetch.latency", 6, 1, 4096, "cycles", "look-up and filter of a fragment whose texels are in the cache");
  p.integer("texture_fetch.capacity", 64, 1, 1 << 20, "tokens", "fragments in flight, waiting for memory or done");
  p.integer("texture_fetch.batch", 1, 1, 4096, "tokens", "fragments gathered before the first of them is looked up");
  p.integer("texture_fetch.cache.sets", 32, 1, 1 << 20, "sets", "texture cache: sets, a power of two");
  p.integer("texture_fetch.cache.ways", 4, 1, 1024, "lines", "texture cache: lines of a set, replaced least recently used first");
  p.integer("texture_fetch.cache.line_bytes", 64, 1, 4096, "bytes", "texture cache: bytes of a line, a power of two");
  p.integer("memory.tag_latency", 1, 0, 4096, "cycles", "from the start of a look-up to its request to memory");
  p.integer("memory.latency", 40, 1, 1 << 20, "cycles", "from the grant of a line to its arrival");
  p.integer("memory.cycles_per_line", 4, 1, 1 << 20, "cycles", "bus occupation of a line");
  p.integer("memory.outstanding", 8, 1, 4096, "lines", "misses in flight");
}

TextureFetchConfig::TextureFetchConfig(const Configuration& c)
    : filter(filter_called(c.choice("texture_fetch.filter"))),
      footprints_per_cycle(static_cast<int>(c.integer("texture_fetch.footprints_per_cycle"))) {
  cache.sets = static_cast<int>(c.integer("texture_fetch.cache.sets"));
  cache.ways = static_cast<int>(c.integer("texture_fetch.cache.ways"));
  cache.line_bytes = static_cast<int>(c.integer("texture_fetch.cache.line_bytes"));
  TextureCache{cache};  // refuses what it cannot build
}

TextureFetch::TextureFetch(std::shared_ptr<const PipelineContext> context, const TextureFetchConfig& config)
    : context_(std::move(context)), config_(config), cache_(config.cache) {
  colour_plane_ = context_->planes.index("tex.r");
  map_plane_ = context_->planes.index("map." + context_->designs.front().map.channels.front().name);
  // Objects that share a texture share it in memory; a bump map is shared by objects of one design.
  std::map<const Texture*, int> colours;
  std::map<std::pair<const Texture*, int>, int> maps;
  for (std::size_t i = 0; i < context_->scene->objects.size(); ++i) {
    const SceneObject& object = context_->scene->objects[i];
    BUMP_ASSERT(object.colour && object.colour->channels == 3 && object.normals && object.normals->channels == 3);
    const int design = context_->design_of_object[i];
    auto colour = colours.find(object.colour.get());
    if (colour == colours.end()) colour = colours.emplace(object.colour.get(), place(object.colour, nullptr)).first;
    auto map = maps.find({object.normals.get(), design});
    if (map == maps.end()) {
      const BumpEncoding& encoding = context_->designs[static_cast<std::size_t>(design)].map;
      auto exact = std::make_shared<const Texture>(encode_bump_map(*object.normals, encoding));
      const bool is_fixed = context_->options.arithmetic == Arithmetic::fixed;
      auto hardware = is_fixed ? std::make_shared<const Texture>(quantise_texels(*exact, encoding)) : exact;
      map = maps.emplace(std::make_pair(object.normals.get(), design), place(hardware, context_->separate_exact() ? exact : nullptr)).first;
    }
    objects_.push_back({colour->second, map->second});
  }
}

int TextureFetch::place(std::shared_ptr<const Texture> hardware, std::shared_ptr<const Texture> exact) {
  BUMP_ASSERT(!hardware->levels.empty());
  const std::uint64_t base = residents_.empty() ? 0 : residents_.back().layout.end();
  TextureLayout layout(*hardware, base, config_.cache.line_bytes);
  residents_.push_back({std::move(hardware), std::move(exact), std::move(layout)});
  return static_cast<int>(residents_.size()) - 1;
}

void TextureFetch::touch(const Resident& texture, const TexelTap* taps, int count) {
  counters_.reads += count;
  for (int i = 0; i < count; ++i) {
    if (i == 0 || taps[i].level != taps[i - 1].level) ++footprints_;
    const std::uint64_t address = texture.layout.address(taps[i].level, taps[i].x, taps[i].y), line = cache_.line_of(address);
    if (std::find(lines_.begin(), lines_.end(), line) != lines_.end()) continue;
    lines_.push_back(line);
    ++counters_.accesses;
    if (cache_.access(address)) {
      ++counters_.hits;
    } else {
      ++counters_.misses;
      ++misses_;
      counters_.bytes += config_.cache.line_bytes;
    }
  }
}

int TextureFetch::fetch(const Resident& texture, double u, double v, double lod, TexelTap taps[8]) {
  const int count = texel_taps(*texture.hardware, config_.filter, u, v, lod_of_access(*texture.hardware, config_.filter, lod), taps);
  touch(texture, taps, count);
  return count;
}

void TextureFetch::process(FragmentBlock& block) {
  const ObjectTextures& textures = objects_[static_cast<std::size_t>(block.object)];
  const Resident& colour = residents_[static_cast<std::size_t>(textures.colour)];
  const Resident& map = residents_[static_cast<std::size_t>(textures.map)];
  const auto channels = static_cast<std::size_t>(map.hardware->channels);
  std::vector<double> texel(std::max<std::size_t>(3, channels));
  const auto store = [&](std::vector<Lanes>& planes, int first, std::size_t count, std::size_t lane) {
    for (std::size_t c = 0; c < count; ++c) planes[static_cast<std::size_t>(first) + c][lane] = texel[c];
  };
  TexelTap taps[8];
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const double u = block.u[lane], v = block.v[lane], lod = block.lod[lane];
    lines_.clear();
    footprints_ = misses_ = 0;
    int count = fetch(colour, u, v, lod, taps);
    filter_texels(*colour.hardware, taps, count, texel.data());
    store(block.hardware, colour_plane_, 3, lane);
    count = fetch(map, u, v, lod, taps);
    filter_texels(*map.hardware, taps, count, texel.data());
    store(block.hardware, map_plane_, channels, lane);
    if (map.exact) {
      filter_texels(*map.exact, taps, count, texel.data());
      store(block.exact, map_plane_, channels, lane);
    }
    TokenRecord record;
    record.interval = static_cast<std::uint32_t>((footprints_ + config_.footprints_per_cycle - 1) / config_.footprints_per_cycle);
    record.misses = static_cast<std::uint16_t>(misses_);
    block.texture_records.push_back(record);
  }
}

}  // namespace bump
