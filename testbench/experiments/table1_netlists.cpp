#include "testbench/experiments/table1_netlists.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "datapath/vertex_program.h"
#include "units/colour_unit.h"
#include "units/interpolators.h"
#include "units/vertex_processor.h"

namespace bump {

namespace {

Scene one_triangle() {
  auto mesh = std::make_shared<Mesh>();
  for (const glm::dvec3& position : {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
    Vertex vertex;
    vertex.position = position;
    mesh->vertices.push_back(vertex);
  }
  mesh->triangles.push_back({0, 1, 2});
  Scene scene;
  scene.name = "one triangle";
  scene.lights.emplace_back();
  SceneObject object;
  object.mesh = mesh;
  scene.objects.push_back(object);
  return scene;
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) result.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

struct Setting {
  std::string key, value;
};

std::vector<Setting> parse(std::string_view settings) {
  std::vector<Setting> result;
  for (const std::string& word : words(settings)) {
    const std::size_t equals = word.find('=');
    result.push_back({word.substr(0, equals), word.substr(equals + 1)});
  }
  return result;
}

/// Per node: whether the nodes or outputs whose names begin with one of the prefixes need it.
std::vector<bool> leads_to(const Netlist& netlist, const std::vector<std::string>& prefixes) {
  const auto matches = [&](const std::string& name) {
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const std::string& prefix) { return name.compare(0, prefix.size(), prefix) == 0; });
  };
  const std::vector<Node>& nodes = netlist.nodes();
  std::vector<bool> needed(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) needed[i] = matches(nodes[i].name);
  for (const Netlist::Port& port : netlist.outputs())
    if (matches(port.name)) needed[static_cast<std::size_t>(port.node)] = true;
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (needed[i])
      for (const int operand : nodes[i].operands) needed[static_cast<std::size_t>(operand)] = true;
  return needed;
}

const Table& table_of(const Netlist& netlist, const Node& node) {
  return *netlist.tables()[static_cast<std::size_t>(node.table)];
}

std::vector<const Netlist*> netlists_of(const Design& design, std::string_view unit) {
  std::vector<const Netlist*> netlists;
  if (unit.empty() || unit == "environment") netlists.push_back(&design.environment);
  if (unit.empty() || unit == "illumination") {
    if (design.light_maps) netlists.push_back(&design.light_maps->address);
    netlists.push_back(&design.illumination);
  }
  return netlists;
}

std::int64_t map_bits(const Netlist& netlist) {
  std::int64_t bits = 0;
  for (const Node& node : netlist.nodes())
    if (node.op == Op::table && table_of(netlist, node).is_map()) bits += table_of(netlist, node).bits();
  return bits;
}

/// Of the largest table that holds the material; 0 if none does.
std::int64_t light_table_bits(const Netlist& netlist) {
  std::int64_t bits = 0;
  for (const TablePtr& table : netlist.tables())
    if (table->per_material) bits = std::max(bits, table->bits());
  return bits;
}

}  // namespace

BuiltScheme build_scheme(const Scheme& scheme, const Configuration& configuration) {
  return build_scheme(scheme, configuration, one_triangle());
}

BuiltScheme build_scheme(const Scheme& scheme, const Configuration& configuration, const Scene& scene) {
  const Material material = scene.objects.empty() ? Material{} : scene.objects.front().material;
  ContextOptions options;
  options.shading = VertexProcessorConfig(configuration).space;
  const auto context = make_context(scene, {scheme.design(configuration, material)}, std::vector<int>(scene.objects.size(), 0), options);
  BuiltScheme built;
  built.design = context->designs.front();
  built.colour = colour_netlist(scene, material, ColourUnitConfig(configuration),
                                built.design.light_maps ? LightSum::in_light_maps : LightSum::in_colour_unit);
  built.interpolators = interpolator_netlist(*context);
  built.transform = vertex_transform(*context);
  built.interpolator_components = interpolator_components(*context);
  built.schedules = make_schedules(built.design, built.colour, configuration);
  return built;
}

Configuration with_settings(const Configuration& configuration, std::string_view settings) {
  Configuration result = configuration;
  for (const Setting& setting : parse(settings)) result.set_text(setting.key, setting.value, Location("other reading"));
  return result;
}

bool has_settings(const Configuration& configuration, std::string_view settings) {
  const std::vector<Setting> parsed = parse(settings);
  return std::all_of(parsed.begin(), parsed.end(), [&](const Setting& setting) {
    const auto entry = configuration.entries().find(setting.key);
    return entry != configuration.entries().end() && to_string(entry->second.value) == setting.value;
  });
}

Inventory step_count(const BuiltScheme& built, std::string_view step, Portion portion, bool colour_blending) {
  Inventory sum;
  for (const Netlist* netlist : netlists_of(built.design, step)) sum += count(*netlist, portion);
  if (step != "illumination" || portion == Portion::addition) return sum;
  if (built.design.light_maps) sum.maps += static_cast<int>(built.design.light_maps->maps.size());
  if (colour_blending) sum += count(built.colour, portion);
  return sum;
}

Inventory part_count(const Design& design, const published::Part& part) {
  Inventory sum;
  for (const Netlist* netlist : netlists_of(design, part.unit)) {
    const std::vector<std::string> to = words(part.to), without = words(part.without);
    const std::vector<bool> in = leads_to(*netlist, to), out = leads_to(*netlist, without);
    std::vector<bool> which;
    for (std::size_t i = 0; i < netlist->nodes().size(); ++i) {
      const Node& node = netlist->nodes()[i];
      const bool light_table = node.op == Op::table && table_of(*netlist, node).per_material;
      which.push_back(!node.addition && (to.empty() || in[i]) && !out[i] && !(part.without_light_tables && light_table));
    }
    sum += count_nodes(*netlist, which);
  }
  return sum;
}

std::optional<double> part_bytes(const BuiltScheme& built, const published::Part& part, published::Storage storage) {
  using published::Storage;
  double bits = 0;
  for (const Netlist* netlist : netlists_of(built.design, part.unit)) {
    switch (storage) {
      case Storage::tables:
        bits += static_cast<double>(count(*netlist, Portion::published).table_bits - map_bits(*netlist));
        break;
      case Storage::distinct:
        bits += static_cast<double>(count(*netlist, Portion::published).distinct_table_bits);
        break;
      case Storage::light_tables:
        bits = std::max(bits, static_cast<double>(light_table_bits(*netlist)));
        break;
      case Storage::maps:
        bits += static_cast<double>(map_bits(*netlist));
        break;
      case Storage::light_map:
        break;
      case Storage::all:
        bits += static_cast<double>(count(*netlist, Portion::all).table_bits);
        break;
    }
  }
  double bytes = bits / 8;
  if (storage == Storage::all) bytes += light_map_bytes(built.design);
  if (storage == Storage::light_map && built.design.light_maps && !built.design.light_maps->maps.empty())
    bytes = light_map_bytes(built.design) / static_cast<double>(built.design.light_maps->maps.size());
  return bytes > 0 ? std::optional<double>(bytes) : std::nullopt;
}

double light_map_bytes(const Design& design) {
  if (!design.light_maps) return 0;
  double bits = 0;
  for (const LightMaps::Map& map : design.light_maps->maps) bits += std::ldexp(map.word.width, design.light_maps->address_bits);
  return bits / 8;
}

}  // namespace bump
