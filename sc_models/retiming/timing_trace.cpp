#include "retiming/timing_trace.h"

#include <algorithm>

#include "datapath/sha256.h"
#include "units/colour_unit.h"

namespace bump {

namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(ErrorKind::internal, {"the timing trace contradicts itself: " + what, {}, "", "record it again"});
}

void hash_netlist(Sha256& hash, const Netlist& netlist) {
  std::string text = netlist.name() + "\n";
  for (const Node& node : netlist.nodes()) {
    text += node.name + " " + name_of(node.op) + " " + to_string(node.format);
    for (const int operand : node.operands) text += " " + std::to_string(operand);
    text += "\n";
  }
  for (const Netlist::Port& port : netlist.outputs()) text += port.name + " " + std::to_string(port.node) + "\n";
  hash.update(text.data(), text.size());
}

std::vector<Material> distinct_materials(const Scene& scene) {
  std::vector<Material> materials;
  for (const SceneObject& object : scene.objects)
    if (std::find(materials.begin(), materials.end(), object.material) == materials.end()) materials.push_back(object.material);
  return materials;
}

bool takes_and_gives_one(const TokenRecord& r) {
  return (r.take & r.release & r.give & 1U) != 0;
}

}  // namespace

void check_trace(const TimingTrace& trace) {
  const RecordedAccesses& accesses = trace.accesses;
  require(accesses.empty() || accesses.texels.fragments == trace.fragments(), "fragments with addresses are not those fetched");
  require(accesses.words.fragments == (accesses.empty() ? 0 : trace.streams[traced::light_map].tokens),
          "words with addresses are not those fetched");
  check_accesses(accesses);
  const TokenStream& raster = trace.streams[traced::raster];
  std::int64_t released = 0, given = 0;
  for (const TokenStream::Run& run : raster.runs) {
    const TokenRecord& record = raster.record(run);
    require((record.take & 1U) != 0, "a token of the rasterizer belongs to no triangle");
    if ((record.release & 1U) != 0) released += run.count;
    if ((record.give & 1U) != 0) given += run.count;
  }
  require(raster.runs.empty() || (raster.record(raster.runs.back()).release & 1U) != 0, "the last triangle does not end");
  require(trace.streams[traced::setup].tokens == trace.triangles(), "triangles set up are not those that entered");
  require(released == trace.triangles(), "triangles rasterized are not those that entered");
  require(given == trace.fragments(), "fragments fetched are not those rasterized");
  const std::int64_t fetched = trace.streams[traced::light_map].tokens;
  require(fetched == 0 || fetched == given, "fragments with light maps are not those rasterized");
  for (std::size_t i = 0; i < traced::count; ++i) {
    for (const TokenRecord& record : trace.streams[i].kinds) {
      require(record.interval >= 1, "an interval of 0 cycles");
      require(i == traced::raster || takes_and_gives_one(record), "a token that does not take and give one item");
      require(record.misses == 0 || i == traced::texture || i == traced::light_map, "a miss where there is no memory");
    }
  }
}

TracedDesign make_traced_design(const Scene& scene, const Scheme& scheme, const Configuration& configuration) {
  if (scene.objects.empty()) throw Error({"the scene has no object", {}, "its material decides how the units are built", ""});
  const Material& material = scene.objects.front().material;
  TracedDesign traced;
  traced.design = scheme.design(configuration, material);
  const bool maps = traced.design.light_maps.has_value();
  traced.passes = maps ? 1 : static_cast<int>(scene.lights.size());
  traced.colour =
      colour_netlist(scene, material, ColourUnitConfig(configuration), maps ? LightSum::in_light_maps : LightSum::in_colour_unit);
  return traced;
}

TracedDesign make_traced_design(const TimingTrace& trace, const Scheme& scheme, const Configuration& configuration) {
  Scene scene;
  for (const double intensity : trace.lights) {
    scene.lights.emplace_back();
    scene.lights.back().intensity = intensity;
  }
  for (const Material& material : trace.materials) {
    scene.objects.emplace_back();
    scene.objects.back().material = material;
  }
  return make_traced_design(scene, scheme, configuration);
}

std::string hash_of_netlists(const TracedDesign& traced) {
  const Design& design = traced.design;
  Sha256 hash;
  if (design.conversion) hash_netlist(hash, *design.conversion);
  hash_netlist(hash, design.environment);
  if (design.light_maps) hash_netlist(hash, design.light_maps->address);
  hash_netlist(hash, design.illumination);
  hash_netlist(hash, traced.colour);
  return hash.hex();
}

void TraceRecorder::add(const TimingRecords& records) {
  builders_[traced::vertex].append(records.vertex);
  builders_[traced::setup].append(records.setup);
  builders_[traced::raster].append(records.raster);
  builders_[traced::texture].append(records.texture);
  builders_[traced::light_map].append(records.light_map);
}

TimingTrace TraceRecorder::finish(const Scene& scene, const Scheme& scheme, const Configuration& configuration, std::int64_t cycles) {
  TimingTrace trace;
  trace.scheme = scheme.page().id;
  trace.scene = scene.name;
  trace.width = scene.width;
  trace.height = scene.height;
  trace.inputs = scene.inputs;
  trace.materials = distinct_materials(scene);
  for (const Light& light : scene.lights) trace.lights.push_back(light.intensity);
  for (const auto& [key, entry] : configuration.entries()) trace.configuration.emplace_back(key, to_string(entry.value));
  trace.netlists = hash_of_netlists(make_traced_design(scene, scheme, configuration));
  trace.cycles = cycles;
  for (std::size_t i = 0; i < traced::count; ++i) trace.streams[i] = builders_[i].stream();
  trace.accesses = accesses_.finish();
  check_trace(trace);
  return trace;
}

}  // namespace bump
