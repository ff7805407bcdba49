#include "testbench/experiments/fit_widths.h"

#include <fmt/core.h>

#include <array>
#include <optional>

namespace bump {

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void add(const Netlist& netlist, std::string& text) {
  text += netlist.name() + ":\n";
  for (const Node& node : netlist.nodes()) {
    text += fmt::format("{} {} {} {} {} {} {} {}", name_of(node.op), node.name, to_string(node.format), node.amount, node.value, node.low,
                        node.high, node.second_port);
    for (const int operand : node.operands) text += fmt::format(" {}", operand);
    if (node.op == Op::table) {
      const Table& table = *netlist.tables()[static_cast<std::size_t>(node.table)];
      text += fmt::format(" {} {} {} {} {} {} {}", table.name, table.formula, to_string(table.index), static_cast<int>(table.folding),
                          table.address_bits, table.min_exponent, table.exponent_bits);
      for (const MapField& field : table.fields) text += fmt::format(" {} {}", to_string(field.index), field.address_bits);
      for (const Column& column : table.columns) text += " " + column.name + " " + to_string(column.format);
    }
    text += "\n";
  }
}

/// Texels may be coarser than their format.
void add_texels(const BumpEncoding& map, std::string& text) {
  constexpr std::array<std::array<double, 3>, 4> normals = {{{0.0, 0.0, 1.0}, {0.6, 0.0, 0.8}, {-0.48, 0.6, 0.64}, {0.36, -0.48, 0.8}}};
  for (const BumpEncoding::Channel& channel : map.channels) text += channel.name + " " + to_string(channel.format) + "\n";
  if (!map.encode || map.channels.empty()) return;
  for (const auto& normal : normals) {
    std::vector<double> values(map.channels.size());
    map.encode(glm::dvec3(normal[0], normal[1], normal[2]), values.data());
    for (const double value : values) text += fmt::format("{} ", value);
  }
  text += "\n";
}

std::optional<std::string> signature_of(const Scheme& scheme, const Configuration& configuration) {
  try {
    return design_signature(scheme.design(configuration, Material{}));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    return std::nullopt;
  }
}

}  // namespace

bool is_fit_width(const Parameter& parameter) {
  return std::holds_alternative<std::int64_t>(parameter.fallback) && (parameter.unit == "bits" || parameter.unit == "stages") &&
         !ends_with(parameter.key, "integer_bits");
}

std::string design_signature(const Design& design) {
  std::string text;
  for (const Interpolant& interpolant : design.interpolants)
    text += fmt::format("{} {}\n", interpolant.name, static_cast<int>(interpolant.kind));
  text += fmt::format("{} {} {}\n", design.map.filterable, design.map.in_object_space, static_cast<bool>(design.map.bake));
  add(design.vertex, text);
  if (design.conversion) add(*design.conversion, text);
  add(design.environment, text);
  add(design.illumination, text);
  if (design.light_maps) {
    const LightMaps& maps = *design.light_maps;
    text += fmt::format("light maps {} {}\n", maps.address_bits, maps.column_bits);
    for (const LightMaps::Map& map : maps.maps) text += map.name + " " + to_string(map.word) + "\n";
    add(maps.address, text);
    add(maps.fill, text);
  }
  add_texels(design.map, text);
  return text;
}

Configuration with_widths(const Configuration& configuration, const std::vector<std::string>& keys, const Widths& widths) {
  Configuration result = configuration;
  for (std::size_t i = 0; i < keys.size(); ++i) result.set(keys[i], std::int64_t{widths[i]}, Location("fit"));
  return result;
}

FitParameters fit_parameters(const Scheme& scheme, const Configuration& configuration) {
  FitParameters parameters;
  std::vector<std::string> keys;
  Widths widest;
  for (const auto& [key, parameter] : configuration.parameters().all()) {
    if (key.rfind(scheme.page().id + ".", 0) != 0 || !is_fit_width(parameter)) continue;
    if (configuration.entries().at(key).origin.file != "default") {
      parameters.set.push_back(key);
      continue;
    }
    keys.push_back(key);
    widest.push_back(static_cast<int>(parameter.high));
  }
  const Configuration wide = with_widths(configuration, keys, widest);
  const std::optional<std::string> signature = signature_of(scheme, wide);
  if (!signature) scheme.design(configuration, Material{});  // throws what is wrong with other settings
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Parameter& parameter = *configuration.parameters().find(keys[i]);
    const int low = static_cast<int>(parameter.low), high = static_cast<int>(parameter.high);
    const bool is_idle = signature && signature_of(scheme, with_widths(wide, {keys[i]}, {low})) == signature;
    if (is_idle) {
      parameters.idle.push_back(keys[i]);
      continue;
    }
    parameters.keys.push_back(keys[i]);
    parameters.ranges.push_back({low, high});
  }
  return parameters;
}

}  // namespace bump
