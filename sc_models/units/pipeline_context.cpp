#include "units/pipeline_context.h"

#include <algorithm>

#include "datapath/invariant.h"
#include "datapath/vertex_program.h"
#include "units/projection.h"

namespace bump {

namespace {

[[noreturn]] void does_not_fit(const std::string& what, const std::string& why) {
  throw Error(ErrorKind::internal, {what, {}, why, "mend the scheme's design (schemes/scheme.h)"});
}

void add_interpolants(PipelineContext& context) {
  const Design& design = context.designs.front();
  const Netlist& vertex = design.vertex;
  if (design.interpolants.size() != vertex.outputs().size())
    does_not_fit(
        std::to_string(design.interpolants.size()) + " interpolants for " + std::to_string(vertex.outputs().size()) + " vertex outputs",
        "they go together one for one");
  const std::vector<bool> per_light = depends_on(vertex, {"L."});
  for (std::size_t i = 0; i < design.interpolants.size(); ++i) {
    const Interpolant& interpolant = design.interpolants[i];
    const Netlist::Port& port = vertex.outputs()[i];
    if (interpolant.name != port.name)
      does_not_fit("interpolant '" + interpolant.name + "' beside vertex output '" + port.name + "'", "they go together in order");
    const bool own = per_light[static_cast<std::size_t>(port.node)];
    if (own && design.light_maps)
      does_not_fit("vertex output '" + port.name + "' depends on the light", "light maps hold the sum of all lights");
    for (int light = 0; light < (own ? context.lights : 1); ++light) {
      const int plane = context.planes.add(plane_of_light(interpolant.name, light));
      context.attributes.push_back({plane, interpolant.kind, static_cast<int>(i), light, -1});
    }
  }
}

void add_probes(PipelineContext& context) {
  int probe = 0;
  for (const char* vector : {"P", "N", "T", "B"}) {
    for (const char* axis : {".x", ".y", ".z"}) {
      const int plane = context.planes.add(std::string("probe.") + vector + axis);
      context.attributes.push_back({plane, InterpolantKind::linear, -1, 0, probe++});
    }
  }
}

void add_outputs(PipelineContext& context, const Netlist& netlist) {
  for (const Netlist::Port& port : netlist.outputs()) {
    if (context.planes.contains(port.name))
      does_not_fit("output '" + port.name + "' of the " + netlist.name() + " netlist",
                   "the name is taken: a later light would read what an earlier one wrote");
    for (int pass = 0; pass < context.passes; ++pass) context.planes.add(plane_of_light(port.name, pass));
  }
}

bool has_port(const std::vector<Netlist::Port>& ports, const std::string& name) {
  return std::any_of(ports.begin(), ports.end(), [&](const Netlist::Port& port) { return port.name == name; });
}

void check_light_maps(const LightMaps& maps) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) does_not_fit("light maps: " + what, "the fetch unit could not be built");
  };
  require(!maps.maps.empty(), "there is no map");
  require(maps.address_bits >= 1 && maps.address_bits <= 24, "2^" + std::to_string(maps.address_bits) + " entries");
  require(maps.column_bits >= 0 && maps.column_bits <= maps.address_bits, "columns of " + std::to_string(maps.column_bits) + " bits");
  require(has_port(maps.address.inputs(), "light_map.base"), "the address netlist does not read light_map.base");
  require(has_port(maps.address.outputs(), "light_map.entry"), "the address netlist delivers no light_map.entry");
  for (const std::string& name : maps.coordinates)
    require(has_port(maps.address.outputs(), name), "coordinate '" + name + "' is no output of the address netlist");
  for (const LightMaps::Map& map : maps.maps)
    require(!map.word.is_real && map.word.width >= 1 && map.word.width <= 31, "words of '" + map.name + "' are " + to_string(map.word));
  require(static_cast<bool>(maps.direction) && static_cast<bool>(maps.centre), "direction or centre is missing");
}

std::vector<std::string> structure_of(const Design& design) {
  std::vector<std::string> names;
  for (const Interpolant& interpolant : design.interpolants) names.push_back(interpolant.name);
  for (const BumpEncoding::Channel& channel : design.map.channels) names.push_back("map." + channel.name);
  const LightMaps* maps = design.light_maps ? &*design.light_maps : nullptr;
  if (maps != nullptr) {
    names.push_back("light maps of 2^" + std::to_string(maps->address_bits) + ", columns 2^" + std::to_string(maps->column_bits));
    for (const LightMaps::Map& map : maps->maps) names.push_back("light." + map.name + " " + to_string(map.word));
  }
  for (const Netlist* netlist :
       {&design.vertex, design.conversion ? &*design.conversion : nullptr, &design.environment, maps != nullptr ? &maps->address : nullptr,
        &design.illumination, maps != nullptr ? &maps->fill : nullptr}) {
    if (netlist == nullptr) continue;
    for (const Node& node : netlist->nodes()) names.push_back(netlist->name() + ":" + name_of(node.op) + ":" + node.name);
  }
  return names;
}

}  // namespace

int PipelineContext::plane(const std::string& name, int light) const {
  const std::string own = plane_of_light(name, light);
  return planes.contains(own) ? planes.index(own) : planes.index(name);
}

const Lanes& PipelineContext::exact_plane(const FragmentBlock& block, int index) const {
  const bool own = separate_exact() && index >= shared_planes;
  return own ? block.exact[static_cast<std::size_t>(index)] : block.hardware[static_cast<std::size_t>(index)];
}

std::int64_t PipelineContext::triangles() const {
  std::int64_t count = 0;
  for (const SceneObject& object : scene->objects) count += static_cast<std::int64_t>(object.mesh->triangles.size());
  return count;
}

std::shared_ptr<const PipelineContext> make_context(const Scene& scene, std::vector<Design> designs, std::vector<int> design_of_object,
                                                    const ContextOptions& options) {
  BUMP_ASSERT(!designs.empty());
  BUMP_ASSERT(design_of_object.size() == scene.objects.size());
  for (const int design : design_of_object) BUMP_ASSERT(design >= 0 && static_cast<std::size_t>(design) < designs.size());
  auto context = std::make_shared<PipelineContext>();
  context->scene = &scene;
  context->designs = std::move(designs);
  context->design_of_object = std::move(design_of_object);
  context->options = options;
  context->lights = static_cast<int>(scene.lights.size());
  context->passes = context->designs.front().light_maps ? 1 : context->lights;

  const std::vector<std::string> structure = structure_of(context->designs.front());
  for (const Design& design : context->designs)
    if (structure_of(design) != structure)
      does_not_fit("designs of two materials differ", "only table contents and constants may follow the material");

  const glm::dmat4 to_clip = world_to_clip(scene.camera, scene.width, scene.height, far_distance(scene));
  for (const SceneObject& object : scene.objects) context->spaces.push_back(make_object_space(scene, object, to_clip, options.shading));

  const Design& design = context->designs.front();
  add_interpolants(*context);
  if (options.probe_directions) add_probes(*context);
  for (const char* channel : {"tex.r", "tex.g", "tex.b"}) context->planes.add(channel);
  if (design.light_maps) context->planes.add("light_map.base");
  context->shared_planes = static_cast<int>(context->planes.size());
  for (const BumpEncoding::Channel& channel : design.map.channels) context->planes.add("map." + channel.name);
  if (design.conversion) {
    for (const Netlist::Port& port : design.conversion->inputs())
      if (port.name.rfind("map.", 0) == 0)
        does_not_fit("input '" + port.name + "' of the conversion netlist", "it runs before the texture unit has fetched the map");
    add_outputs(*context, *design.conversion);
  }
  add_outputs(*context, design.environment);
  if (design.light_maps) {
    check_light_maps(*design.light_maps);
    add_outputs(*context, design.light_maps->address);
    for (const LightMaps::Map& map : design.light_maps->maps) context->planes.add("light." + map.name);
  }
  add_outputs(*context, design.illumination);
  for (const char* channel : {"colour.r", "colour.g", "colour.b"}) context->planes.add(channel);
  return context;
}

}  // namespace bump
