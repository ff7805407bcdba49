#include "units/texture_fetch.h"

#include <map>
#include <tuple>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "units/access_listener.h"
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

/// Marks lanes that read another line than the lane before.
BUMP_LANE_LOOP void mark_changes(const std::uint32_t* __restrict line, int lanes, std::uint32_t* __restrict changed) {
  for (int i = 1; i < lanes; ++i) changed[i] |= line[i] ^ line[i - 1];
}

}  // namespace

void TextureFetchConfig::declare(Parameters& p) {
  p.choice("texture_fetch.filter", "bilinear", {"nearest", "bilinear", "trilinear"},
           "filter of colour texels, and of bump maps that may be filtered");
  p.integer("texture_fetch.footprints_per_cycle", 2, 1, 64, "footprints", "2 x 2 texel footprints that the cache serves each cycle");
  p.integer("texture_fetch.latency", 6, 1, 4096, "cycles", "look-up and filter of a fragment whose texels are in the cache").timing_only =
      true;
  p.integer("texture_fetch.capacity", 64, 1, 1 << 20, "tokens", "fragments in flight, waiting for memory or done").timing_only = true;
  p.integer("texture_fetch.batch", 1, 1, 4096, "tokens", "fragments gathered before the first of them is looked up").timing_only = true;
  p.integer("texture_fetch.cache.sets", 32, 1, 1 << 20, "sets", "texture cache: sets, a power of two");
  p.integer("texture_fetch.cache.ways", 4, 1, 1024, "lines", "texture cache: lines of a set, replaced least recently used first");
  p.integer("texture_fetch.cache.line_bytes", 64, 1, 4096, "bytes", "texture cache: bytes of a line, a power of two");
  p.integer("memory.tag_latency", 1, 1, 4096, "cycles", "from the start of a look-up to its request to memory").timing_only = true;
  p.integer("memory.latency", 40, 1, 1 << 20, "cycles", "from the grant of a line to its arrival").timing_only = true;
  p.integer("memory.cycles_per_line", 4, 1, 1 << 20, "cycles", "bus occupation of a line").timing_only = true;
  p.integer("memory.outstanding", 8, 1, 4096, "lines", "misses in flight").timing_only = true;
}

std::vector<std::string> TextureFetchConfig::look_up_keys() {
  return {"texture_fetch.footprints_per_cycle", "texture_fetch.cache.sets", "texture_fetch.cache.ways", "texture_fetch.cache.line_bytes"};
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

TextureLayout TextureFetch::layout_of(const Texture& texture, std::uint64_t base, int line_bytes) {
  BUMP_ASSERT(!texture.levels.empty());
  TextureLayout layout(texture, base, line_bytes);
  if (!TapBlock::can_hold(texture, layout))
    throw Error({"texture \"" + texture.name + "\" of " + std::to_string(texture.levels.front().width) + " x " +
                     std::to_string(texture.levels.front().height) + " texels",
                 {},
                 "the texture unit numbers texels in 32 bits",
                 "a smaller texture"});
  return layout;
}

int TextureFetch::place(std::shared_ptr<const Texture> hardware, std::shared_ptr<const Texture> exact) {
  TextureLayout layout = layout_of(*hardware, residents_.empty() ? 0 : residents_.back().layout.end(), config_.cache.line_bytes);
  residents_.push_back({std::move(hardware), std::move(exact), std::move(layout)});
  return static_cast<int>(residents_.size()) - 1;
}

void TextureFetch::fetch(const Resident& texture, const AccessLanes& at, FragmentBlock& block, int plane, TapBlock& taps) {
  const auto first = static_cast<std::size_t>(plane);
  taps.find(*texture.hardware, texture.layout, cache_.line_shift(), config_.filter, at, block.lanes);
  taps.weigh(*texture.hardware, block.lanes, &block.hardware[first]);
  if (texture.exact) taps.weigh(*texture.exact, block.lanes, &block.exact[first]);
  if (taps.is_uniform()) {
    counters_.reads += static_cast<std::int64_t>(taps.taps()) * block.lanes;
  } else {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) counters_.reads += taps.taps_of(lane);
  }
}

AccessLanes TextureFetch::scaled(const ObjectTextures& textures, const AccessLanes& at, int lanes) {
  const glm::dvec2 &origin = textures.map_origin, &scale = textures.map_scale;
  if (origin == glm::dvec2(0) && scale == glm::dvec2(1)) return at;  // as it is for maps that were not made for one surface
  for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) {
    scaled_[0][i] = (at.u[i] - origin.x) * scale.x;
    scaled_[1][i] = (at.v[i] - origin.y) * scale.y;
    scaled_[2][i] = at.dudx[i] * scale.x;
    scaled_[3][i] = at.dvdx[i] * scale.y;
    scaled_[4][i] = at.dudy[i] * scale.x;
    scaled_[5][i] = at.dvdy[i] * scale.y;
  }
  return {scaled_[0].data(), scaled_[1].data(), scaled_[2].data(), scaled_[3].data(), scaled_[4].data(), scaled_[5].data()};
}

std::size_t TextureFetch::look_up(const Resident& texture, const TapBlock& taps, std::size_t lane, int& misses) {
  const std::uint64_t first = cache_.line_of(texture.layout.start(0));
  std::array<std::uint32_t, TapBlock::most_taps> seen;  // textures do not share lines
  std::size_t count = 0;
  for (std::size_t tap = 0; tap < taps.taps(); ++tap) {
    const std::uint32_t line = taps.line(tap)[lane];
    if (count > 0 && seen[count - 1] == line) continue;  // mostly so
    bool is_known = false;
    for (std::size_t i = 0; i < count; ++i) is_known = is_known || seen[i] == line;
    if (is_known) continue;
    seen[count++] = line;
    if (!cache_.access_line(first + line)) ++misses;
  }
  return count;
}

void TextureFetch::look_up(const std::array<const Resident*, 2>& textures, FragmentBlock& block) {
  const auto lanes = static_cast<std::size_t>(block.lanes);
  changed_.fill(0);
  for (std::size_t t = 0; t < 2 && textures[t] != nullptr; ++t) {
    for (std::size_t tap = 0; tap < taps_[t].taps(); ++tap) mark_changes(taps_[t].line(tap).data(), block.lanes, changed_.data());
    if (taps_[t].is_uniform()) continue;
    for (std::size_t lane = 1; lane < lanes; ++lane) changed_[lane] |= taps_[t].taps_of(lane) != taps_[t].taps_of(lane - 1) ? 1U : 0U;
  }
  for (std::size_t lane = 0; lane < lanes;) {
    int footprints = 0, misses = 0;  // a footprint a level
    std::size_t lines = 0;
    for (std::size_t t = 0; t < 2 && textures[t] != nullptr; ++t) {
      lines += look_up(*textures[t], taps_[t], lane, misses);
      footprints += taps_[t].taps_of(lane) > 4 ? 2 : 1;
    }
    TokenRecord record;
    record.interval = static_cast<std::uint32_t>((footprints + config_.footprints_per_cycle - 1) / config_.footprints_per_cycle);
    record.misses = static_cast<std::uint16_t>(misses);
    block.texture_records.push_back(record);
    // A fragment that reads the same lines as the one before finds them all, and leaves them in the same order of use, if no set can have
    // lost one of them on the way.
    const std::size_t begin = ++lane;
    if (lines <= static_cast<std::size_t>(config_.cache.ways))
      while (lane < lanes && changed_[lane] == 0) ++lane;
    const auto alike = static_cast<std::int64_t>(lane - begin);
    record.misses = 0;
    block.texture_records.append(record, alike);
    counters_.accesses += static_cast<std::int64_t>(lines) * (1 + alike);
    counters_.hits += static_cast<std::int64_t>(lines) * (1 + alike) - misses;
    counters_.misses += misses;
    counters_.bytes += static_cast<std::int64_t>(misses) * config_.cache.line_bytes;
  }
}

void TextureFetch::process(FragmentBlock& block) {
  const ObjectTextures& textures = objects_[static_cast<std::size_t>(block.object)];
  const Resident& colour = residents_[static_cast<std::size_t>(textures.colour)];
  const Resident* map = has_map_ ? &residents_[static_cast<std::size_t>(textures.map)] : nullptr;
  const AccessLanes at{block.u.data(), block.v.data(), block.dudx.data(), block.dvdx.data(), block.dudy.data(), block.dvdy.data()};
  fetch(colour, at, block, colour_plane_, taps_[0]);
  if (map) fetch(*map, scaled(textures, at, block.lanes), block, map_plane_, taps_[1]);
  if (listener_) listener_->add_texels({textures.colour, has_map_ ? textures.map : -1}, taps_, block.lanes);
  look_up({&colour, map}, block);
}

void TextureFetch::listen(AccessListener& listener) {
  listener_ = &listener;
  for (const Resident& texture : residents_) listener.add_texture(*texture.hardware);
}

}  // namespace bump
