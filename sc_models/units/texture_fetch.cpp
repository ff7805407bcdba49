#include "units/texture_fetch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "datapath/invariant.h"
#include "units/bump_map.h"

namespace bump {

namespace {

Filter filter_called(const std::string& name) {
  if (name == "nearest") return Filter::nearest;
  return name == "bilinear" ? Filter::bilinear : Filter::trilinear;
}

void refuse_other_space(const BumpEncoding& encoding, const PipelineContext& context) {
  if (encoding.in_object_space && context.options.shading != ShadingSpace::object)
    throw Error({"a bump map in object space beside vectors in another space",
                 {},
                 "its normals are dotted with L and H as they are",
                 "vertex_processor.space=object, or a bump map in tangent space"});
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
  p.integer("memory.tag_latency", 1, 1, 4096, "cycles", "from the start of a look-up to its request to memory");
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
  const std::vector<BumpEncoding::Channel>& channels = context_->designs.front().map.channels;
  has_map_ = !channels.empty();
  if (has_map_) map_plane_ = context_->planes.index("map." + channels.front().name);
  // Objects that share a texture share it in memory; a bump map is shared by objects of one design.
  std::map<const Texture*, int> colours;
  using MapKey = std::tuple<const Texture*, const Texture*, const Mesh*, int>;  // heights and mesh: of a map that belongs to a surface
  std::map<MapKey, ObjectTextures> maps;
  for (std::size_t i = 0; i < context_->scene->objects.size(); ++i) {
    const SceneObject& object = context_->scene->objects[i];
    BUMP_ASSERT(object.colour && object.colour->channels == 3 && object.normals && object.normals->channels == 3);
    const int design = context_->design_of_object[i];
    auto colour = colours.find(object.colour.get());
    if (colour == colours.end()) colour = colours.emplace(object.colour.get(), place(object.colour, nullptr)).first;
    if (!has_map_) {
      objects_.push_back({colour->second, -1});
      continue;
    }
    const BumpEncoding& encoding = context_->designs[static_cast<std::size_t>(design)].map;
    refuse_other_space(encoding, *context_);
    const bool baked = static_cast<bool>(encoding.bake);
    const MapKey key{object.normals.get(), baked ? object.heights.get() : nullptr, baked ? object.mesh.get() : nullptr, design};
    auto map = maps.find(key);
    if (map == maps.end()) {
      ObjectTextures textures;
      if (baked) {
        const SurfaceMap surface = encoding.bake(object);
        textures.map = place_map(surface.normals, encoding);
        textures.map_origin = surface.uv_origin;
        textures.map_scale = surface.uv_scale;
      } else {
        textures.map = place_map(*object.normals, encoding);
      }
      map = maps.emplace(key, textures).first;
    }
    objects_.push_back(map->second);
    objects_.back().colour = colour->second;
  }
}

int TextureFetch::place_map(const Texture& normals, const BumpEncoding& encoding) {
  auto exact = std::make_shared<const Texture>(encode_bump_map(normals, encoding));
  const bool is_fixed = context_->options.arithmetic == Arithmetic::fixed;
  auto hardware = is_fixed ? std::make_shared<const Texture>(quantise_texels(*exact, encoding)) : exact;
  return place(hardware, context_->separate_exact() ? exact : nullptr);
}

int TextureFetch::place(std::shared_ptr<const Texture> hardware, std::shared_ptr<const Texture> exact) {
  BUMP_ASSERT(!hardware->levels.empty());
  const std::uint64_t base = residents_.empty() ? 0 : residents_.back().layout.end();
  TextureLayout layout(*hardware, base, config_.cache.line_bytes);
  residents_.push_back({std::move(hardware), std::move(exact), std::move(layout)});
  return static_cast<int>(residents_.size()) - 1;
}

void TextureFetch::look_up(std::uint64_t address) {
  const std::uint64_t line = cache_.line_of(address);
  for (std::size_t i = line_count_; i-- > 0;)
    if (lines_[i] == line) return;
  lines_[line_count_++] = line;
  ++counters_.accesses;
  if (cache_.access(address)) {
    ++counters_.hits;
  } else {
    ++counters_.misses;
    ++misses_;
    counters_.bytes += config_.cache.line_bytes;
  }
}

void TextureFetch::fetch_footprint(const Resident& texture, const BilinearFootprint& f, FragmentBlock& block, std::size_t lane, int plane) {
  counters_.reads += 4;
  ++footprints_;
  const auto same_tile = [](int a, int b) {
    return static_cast<unsigned>(a) / TextureLayout::tile == static_cast<unsigned>(b) / TextureLayout::tile;
  };
  look_up(texture.layout.address(0, f.x0, f.y0));
  if (!(texture.layout.tile_in_line() && same_tile(f.x0, f.x1) && same_tile(f.y0, f.y1))) {
    look_up(texture.layout.address(0, f.x1, f.y0));
    look_up(texture.layout.address(0, f.x0, f.y1));
    look_up(texture.layout.address(0, f.x1, f.y1));
  }
  const auto store_in = [&](std::vector<Lanes>& planes) {
    return [&planes, lane, plane](std::size_t channel, double value) { planes[static_cast<std::size_t>(plane) + channel][lane] = value; };
  };
  filter_footprint(*texture.hardware, texture.hardware->levels.front(), f, store_in(block.hardware));
  if (texture.exact) filter_footprint(*texture.exact, texture.exact->levels.front(), f, store_in(block.exact));
}

void TextureFetch::fetch(const Resident& texture, const Access& access, FragmentBlock& block, std::size_t lane, int plane) {
  const Texture& hardware = *texture.hardware;
  const double u = access.u, v = access.v;
  // The bilinear filter reads level 0 only (memory/level_of_detail.h): nearly all fetches of nearly all runs.
  BilinearFootprint footprint;
  if (config_.filter == Filter::bilinear && hardware.filterable && find_footprint(hardware, hardware.levels.front(), u, v, footprint)) {
    fetch_footprint(texture, footprint, block, lane, plane);
    return;
  }
  TexelTap taps[8];
  const int count = texel_taps(hardware, config_.filter, u, v, lod_of_access(hardware, config_.filter, access.derivatives), taps);
  counters_.reads += count;
  for (int i = 0; i < count; ++i) {
    if (i == 0 || taps[i].level != taps[i - 1].level) ++footprints_;
    look_up(texture.layout.address(taps[i].level, taps[i].x, taps[i].y));
  }
  const auto store = [&](const Texture& from, std::vector<Lanes>& planes) {
    filter_texels(from, taps, count, texel_.data());
    for (std::size_t c = 0; c < static_cast<std::size_t>(from.channels); ++c) planes[static_cast<std::size_t>(plane) + c][lane] = texel_[c];
  };
  store(hardware, block.hardware);
  if (texture.exact) store(*texture.exact, block.exact);
}

void TextureFetch::process(FragmentBlock& block) {
  const ObjectTextures& textures = objects_[static_cast<std::size_t>(block.object)];
  const Resident& colour = residents_[static_cast<std::size_t>(textures.colour)];
  const Resident* map = has_map_ ? &residents_[static_cast<std::size_t>(textures.map)] : nullptr;
  texel_.resize(static_cast<std::size_t>(std::max(colour.hardware->channels, map ? map->hardware->channels : 0)));
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    line_count_ = 0;
    footprints_ = misses_ = 0;
    const Access access{block.u[lane], block.v[lane], {block.dudx[lane], block.dvdx[lane], block.dudy[lane], block.dvdy[lane]}};
    fetch(colour, access, block, lane, colour_plane_);
    if (map) {
      // Offset and scale are 0 and 1, and change no bit, unless the map was made for this surface.
      const glm::dvec2 &origin = textures.map_origin, &scale = textures.map_scale;
      const TextureDerivatives& d = access.derivatives;
      const Access scaled{(access.u - origin.x) * scale.x,
                          (access.v - origin.y) * scale.y,
                          {d.dudx * scale.x, d.dvdx * scale.y, d.dudy * scale.x, d.dvdy * scale.y}};
      fetch(*map, scaled, block, lane, map_plane_);
    }
    TokenRecord record;
    record.interval = static_cast<std::uint32_t>((footprints_ + config_.footprints_per_cycle - 1) / config_.footprints_per_cycle);
    record.misses = static_cast<std::uint16_t>(misses_);
    block.texture_records.push_back(record);
  }
}

}  // namespace bump
