#include "units/light_map_fetch.h"

#include <algorithm>
#include <cmath>

#include "datapath/invariant.h"
#include "units/access_listener.h"

namespace bump {

namespace {

const Netlist* address_of(const Design& design) {
  return &design.light_maps->address;
}

const LightMaps& maps_of(const PipelineContext& context, int object = 0) {
  BUMP_ASSERT(context.designs.front().light_maps.has_value());
  if (context.design_of_object.empty()) return *context.designs.front().light_maps;
  return *context.design_of(object).light_maps;
}

std::int64_t entries_of(const LightMaps& maps) {
  return std::int64_t{1} << maps.address_bits;
}

/// The words of base and entry limit the number of objects.
void check_objects(const PipelineContext& context) {
  const LightMaps& maps = maps_of(context);
  const auto objects = static_cast<std::int64_t>(context.scene->objects.size());
  double highest = 0;
  for (const Netlist::Port& port : maps.address.outputs())
    if (port.name == "light_map.entry") highest = maps.address.nodes()[static_cast<std::size_t>(port.node)].format.highest();
  for (const Netlist::Port& port : maps.address.inputs())
    if (port.name == "light_map.base")
      highest = std::min(
          highest, maps.address.nodes()[static_cast<std::size_t>(port.node)].format.highest() + static_cast<double>(entries_of(maps)) - 1);
  const auto most = static_cast<std::int64_t>((highest + 1) / static_cast<double>(entries_of(maps)));
  if (objects > most)
    throw Error({"the scene has " + std::to_string(objects) + " objects",
                 {},
                 "the scheme's addresses tell the light maps of " + std::to_string(most) + " apart",
                 "fewer objects in the scene, or another scheme"});
}

}  // namespace

void LightMapFetchConfig::declare(Parameters& p) {
  p.integer("light_map_fetch.multipliers", 0, 0, 4096, "multipliers",
            "of the address, built and time-shared; 0 builds one for every product")
      .timing_only = true;
  p.integer("light_map_fetch.latency", 2, 1, 4096, "cycles", "look-up of a fragment whose words are in the cache, behind its address")
      .timing_only = true;
  p.integer("light_map_fetch.capacity", 64, 1, 1 << 20, "tokens", "fragments in flight, waiting for memory or done").timing_only = true;
  p.integer("light_map_fetch.reads_per_cycle", 2, 1, 64, "words", "words of light maps that the cache serves each cycle");
  p.integer("light_map_fetch.cache.sets", 32, 1, 1 << 20, "sets", "light-map cache: sets, a power of two");
  p.integer("light_map_fetch.cache.ways", 4, 1, 1024, "lines", "light-map cache: lines of a set, replaced least recently used first");
  p.integer("light_map_fetch.cache.line_bytes", 64, 1, 4096, "bytes", "light-map cache: bytes of a line, a power of two");
  // No figures are published: a bank on the chip that holds the logic is nearer and wider than a texture memory beside it.
  p.integer("light_memory.tag_latency", 1, 1, 4096, "cycles", "from the address of a light-map word to its request to memory").timing_only =
      true;
  p.integer("light_memory.latency", 10, 1, 1 << 20, "cycles", "from the grant of a line to its arrival").timing_only = true;
  p.integer("light_memory.cycles_per_line", 2, 1, 1 << 20, "cycles", "occupation of the light maps' bank by a line").timing_only = true;
  p.integer("light_memory.outstanding", 8, 1, 4096, "lines", "misses in flight").timing_only = true;
}

std::vector<std::string> LightMapFetchConfig::look_up_keys() {
  return {"light_map_fetch.reads_per_cycle", "light_map_fetch.cache.sets", "light_map_fetch.cache.ways",
          "light_map_fetch.cache.line_bytes"};
}

LightMapFetchConfig::LightMapFetchConfig(const Configuration& c)
    : reads_per_cycle(static_cast<int>(c.integer("light_map_fetch.reads_per_cycle"))) {
  cache.sets = static_cast<int>(c.integer("light_map_fetch.cache.sets"));
  cache.ways = static_cast<int>(c.integer("light_map_fetch.cache.ways"));
  cache.line_bytes = static_cast<int>(c.integer("light_map_fetch.cache.line_bytes"));
  TextureCache(cache, "light-map cache");  // refuses what it cannot build
}

LightMapFetch::LightMapFetch(std::shared_ptr<const PipelineContext> context, const LightMapFetchConfig& config)
    : context_(std::move(context)),
      config_(config),
      layout_(layout_of(maps_of(*context_), config.cache.line_bytes)),
      cache_(config.cache, "light-map cache"),
      address_(context_, address_of),
      entries_(block_lanes),
      normals_(block_lanes),
      sums_(maps_of(*context_).maps.size()),
      counters_(maps_of(*context_).maps.size()) {
  check_objects(*context_);
  const LightMaps& maps = maps_of(*context_);
  for (const Design& design : context_->designs) {
    fills_.push_back(std::make_unique<LightMapFill>(*design.light_maps));
    if (context_->options.arithmetic == Arithmetic::real)
      entry_evaluators_.push_back(make_evaluator(design.light_maps->address, Arithmetic::fixed));
  }
  base_plane_ = context_->planes.index("light_map.base");
  entry_plane_ = context_->planes.index("light_map.entry");
  word_plane_ = context_->planes.index("light." + maps.maps.front().name);
  for (const std::string& coordinate : maps.coordinates) coordinate_planes_.push_back(context_->planes.index(coordinate));
}

LightMapLayout LightMapFetch::layout_of(const LightMaps& maps, int line_bytes) {
  LightMapLayout layout(maps, line_bytes);
  for (std::size_t map = 0; map < maps.maps.size(); ++map) {
    const int bytes = layout.word_bytes(static_cast<int>(map));
    if (bytes > line_bytes)
      throw Error({"light-map cache lines of " + std::to_string(line_bytes) + " bytes",
                   {},
                   "a word of light map '" + maps.maps[map].name + "' takes " + std::to_string(bytes) + " bytes",
                   "light_map_fetch.cache.line_bytes at least " + std::to_string(bytes)});
  }
  return layout;
}

std::int64_t LightMapFetch::words_written() const {
  return entries_of(maps_of(*context_)) * static_cast<std::int64_t>(context_->scene->objects.size());
}

LightMapFill& LightMapFetch::fill_of(int object) {
  return *fills_[static_cast<std::size_t>(context_->design_of_object[static_cast<std::size_t>(object)])];
}

void LightMapFetch::start_object(int object) {
  const auto index = static_cast<std::size_t>(object);
  LightMapFill& fill = fill_of(object);
  fill.set_lights(distant_lights(context_->spaces[index], *context_->scene->objects[index].mesh));
  // Only maps that are read are worked out, one object's at a time; the hardware holds those of all objects.
  if (context_->options.arithmetic == Arithmetic::fixed) fill.fill(words_);
  object_ = object;
}

void LightMapFetch::find_entries(const FragmentBlock& block) {
  const LightMaps& maps = maps_of(*context_, block.object);
  const Lanes* entry = &block.hardware[static_cast<std::size_t>(entry_plane_)];
  std::vector<Lanes> words;
  if (!entry_evaluators_.empty()) {
    words.resize(maps.address.outputs().size());
    std::vector<const double*> inputs;
    std::vector<double*> outputs;
    for (const Netlist::Port& port : maps.address.inputs())
      inputs.push_back(block.hardware[static_cast<std::size_t>(context_->planes.index(port.name))].data());
    for (std::size_t i = 0; i < words.size(); ++i) {
      outputs.push_back(words[i].data());
      if (maps.address.outputs()[i].name == "light_map.entry") entry = &words[i];
    }
    entry_evaluators_[static_cast<std::size_t>(context_->design_of_object[static_cast<std::size_t>(block.object)])]->evaluate(
        inputs.data(), block.lanes, outputs.data());
  }
  const std::int64_t base = block.object * entries_of(maps);
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    entries_[lane] = std::llround((*entry)[lane]) - base;
    BUMP_ASSERT(entries_[lane] >= 0 && entries_[lane] < entries_of(maps));
  }
}

void LightMapFetch::fetch(FragmentBlock& block) {
  const LightMaps& maps = maps_of(*context_, block.object);
  const bool words = context_->options.arithmetic == Arithmetic::fixed;
  TokenRecord record;
  record.interval =
      static_cast<std::uint32_t>((static_cast<int>(maps.maps.size()) + config_.reads_per_cycle - 1) / config_.reads_per_cycle);
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const auto entry = static_cast<std::size_t>(entries_[lane]);
    record.misses = 0;
    for (std::size_t map = 0; map < maps.maps.size(); ++map) {
      LightMapCounters& counted = counters_[map];
      ++counted.reads;
      if (cache_.access(layout_.address(block.object, static_cast<int>(map), entries_[lane]))) {
        ++counted.hits;
      } else {
        ++counted.misses;
        ++record.misses;
        counted.bytes += config_.cache.line_bytes;
      }
      if (!words) continue;
      block.hardware[static_cast<std::size_t>(word_plane_) + map][lane] = to_double(words_.words[map][entry], maps.maps[map].word);
      if (!words_.clipped[map][entry]) continue;
      ++counted.clipped;
      block.diverged[lane] = 1;
    }
    block.light_map_records.push_back(record);
  }
}

void LightMapFetch::evaluate_exact(FragmentBlock& block) {
  const bool separate = context_->separate_exact();
  if (!separate && context_->options.arithmetic == Arithmetic::fixed) return;
  const LightMaps& maps = maps_of(*context_, block.object);
  std::vector<double> coordinates(coordinate_planes_.size());
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i] = context_->exact_plane(block, coordinate_planes_[i])[lane];
    normals_[lane] = maps.direction(coordinates.data());
  }
  fill_of(block.object).evaluate(normals_, block.lanes, sums_);
  std::vector<Lanes>& planes = separate ? block.exact : block.hardware;
  for (std::size_t map = 0; map < sums_.size(); ++map)
    std::copy_n(sums_[map].begin(), block.lanes, planes[static_cast<std::size_t>(word_plane_) + map].begin());
}

void LightMapFetch::process(FragmentBlock& block) {
  if (block.lanes == 0) return;
  if (block.object != object_) start_object(block.object);
  block.hardware[static_cast<std::size_t>(base_plane_)].fill(
      static_cast<double>(block.object * entries_of(maps_of(*context_, block.object))));
  address_.process(block);
  find_entries(block);
  if (listener_) listener_->add_words(block.object, layout_.column_bits(), entries_, block.lanes);
  fetch(block);
  evaluate_exact(block);
}

}  // namespace bump
