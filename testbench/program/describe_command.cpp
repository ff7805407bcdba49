// `bumpsim describe`: everything that the program knows about itself, from the same declarations that the simulation uses.

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "channels/statistics.h"
#include "datapath/inventory.h"
#include "system/pipeline_timing.h"
#include "system/simulation.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/scheme_units.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/results/statistics_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Parameter& p) {
  Json entry = {{"key", p.key}, {"default", to_string(p.fallback)}, {"allowed", allowed(p)}, {"unit", p.unit}, {"meaning", p.meaning}};
  return entry;
}

void print_parameters(const std::vector<const Parameter*>& parameters) {
  std::size_t width = 0;
  for (const Parameter* p : parameters) width = std::max(width, p->key.size());
  for (const Parameter* p : parameters)
    fmt::print("  {:<{}}  {:<8} {}\n  {:<{}}           {}\n", p->key, width, to_string(p->fallback), p->meaning, "", width, allowed(*p));
}

std::vector<const Parameter*> parameters_below(const Parameters& all, const std::string& prefix) {
  std::vector<const Parameter*> found;
  for (const auto& [key, parameter] : all.all())
    if (key == prefix || key.rfind(prefix + ".", 0) == 0) found.push_back(&parameter);
  return found;
}

std::string module_of(const std::string& key) { return key.substr(0, key.find('.')); }

Json counts_json(const Inventory& i) {
  return {{"multipliers", i.multipliers}, {"adders", i.adders}, {"dividers", i.dividers}, {"square_roots", i.square_roots},
          {"tables", i.tables}, {"maps", i.maps}, {"shifters", i.shifters}, {"clamps", i.clamps}, {"selects", i.selects}, {"sign_logic", i.sign_logic},
          {"shifts", i.shifts}, {"index_encoders", i.index_encoders}, {"second_ports", i.second_ports}, {"table_bits", i.table_bits}};
}

void print_units(const Design& design) {
  const auto row = [](const std::string& name, const auto&... cells) {
    constexpr int widths[] = {5, 6, 5, 5, 7, 5, 6, 8, 10, 9};
    const int* width = widths;
    fmt::print("  {:<26}", name);
    (fmt::print(" {:>{}}", cells, *width++), ...);
    fmt::print("\n");
  };
  fmt::print("\n");
  const std::vector<NamedNetlist> units = units_of(design);
  const bool has_shifters = std::any_of(units.begin(), units.end(), [](const NamedNetlist& unit) { return count(*unit.netlist).shifters > 0; });
  const auto with_shifters = [&](const std::string& name, const auto& shifters, const auto&... cells) {
    if (has_shifters) return row(name, cells..., shifters);
    row(name, cells...);
  };
  with_shifters("built, one light", "shifters", "mul", "adders", "div", "sqrt", "tables", "maps", "clamps", "selects", "table bits");
  const auto counts = [&](const std::string& name, const Inventory& i) {
    with_shifters(name, i.shifters, i.multipliers, i.adders, i.dividers, i.square_roots, i.tables, i.maps, i.clamps, i.selects, i.table_bits);
  };
  for (const NamedNetlist& unit : units) {
    counts(unit.name, published_of(unit));
    const Inventory addition = count(*unit.netlist, Portion::addition);
    if (addition.adders + addition.multipliers + addition.tables + addition.dividers + addition.square_roots + addition.maps + addition.shifters > 0)
      counts("  beside the published", addition);
  }
}

Json light_maps_json(const LightMaps& maps) {
  Json list = Json::array();
  for (const LightMaps::Map& map : maps.maps) {
    const std::int64_t entries = std::int64_t{1} << maps.address_bits;
    list.push_back({{"name", map.name}, {"word", to_string(map.word)}, {"entries", entries}, {"bits", entries * map.word.width}});
  }
  return list;
}

int describe_scheme(const Scheme& scheme, bool json) {
  const Configuration configuration(all_parameters());
  const Design design = scheme.design(configuration, Material{});
  const SchemePage& page = scheme.page();
  const auto parameters = parameters_below(configuration.parameters(), page.id);
  if (json) {
    Json document = {{"id", page.id}, {"title", page.title}, {"source", page.source}, {"provenance", page.provenance}, {"summary", page.summary}};
    for (const NamedNetlist& unit : units_of(design)) {
      Json& entry = document["units"][unit.name];
      entry["built"] = counts_json(published_of(unit));
      entry["additional"] = counts_json(count(*unit.netlist, Portion::addition));
      for (const Netlist::Port& port : unit.netlist->inputs()) entry["inputs"].push_back({{"name", port.name}, {"format", to_string(unit.netlist->nodes()[port.node].format)}});
      for (const Netlist::Port& port : unit.netlist->outputs()) entry["outputs"].push_back(port.name);
    }
    if (design.light_maps) document["light_maps"] = light_maps_json(*design.light_maps);
    document["interpolants"] = Json::array();
    for (const Interpolant& i : design.interpolants) document["interpolants"].push_back(i.name);
    document["parameters"] = Json::array();
    for (const Parameter* p : parameters) document["parameters"].push_back(to_json(*p));
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("{}: {}\n  source      {}\n  provenance  {}\n  {}\n", page.id, page.title, page.source, page.provenance, page.summary);
  print_units(design);
  fmt::print("\n  interpolated beside u, v:");
  for (const Interpolant& i : design.interpolants) fmt::print(" {}", i.name);
  fmt::print("\n  bump map texel:");
  for (const auto& channel : design.map.channels) fmt::print(" {} {}", channel.name, to_string(channel.format));
  fmt::print("{}\n", design.map.note.empty() ? "" : " (" + design.map.note + ")");
  if (design.light_maps) {
    fmt::print("  light maps of 2^{} words an object:", design.light_maps->address_bits);
    for (const LightMaps::Map& map : design.light_maps->maps) fmt::print(" {} {}", map.name, to_string(map.word));
    fmt::print("\n");
  }
  for (const NamedNetlist& unit : units_of(design)) {
    fmt::print("  inputs of {}:", unit.name);
    for (const Netlist::Port& port : unit.netlist->inputs()) fmt::print(" {}", port.name);
    fmt::print("\n");
  }
  fmt::print("\nparameters\n");
  print_parameters(parameters);
  return 0;
}

/// Those of the timing plane, then those of the units and pictures.
std::vector<StatisticMeaning> all_meanings() {
  std::vector<StatisticMeaning> meanings = statistic_meanings();
  for (StatisticMeaning& meaning : result_statistic_meanings()) meanings.push_back(std::move(meaning));
  return meanings;
}

int describe_statistics(bool json) {
  if (json) {
    Json document = Json::array();
    for (const StatisticMeaning& s : all_meanings())
      document.push_back({{"module", s.module_kind}, {"statistic", s.statistic}, {"unit", s.unit}, {"meaning", s.meaning}, {"formula", s.formula}});
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  for (const StatisticMeaning& s : all_meanings())
    fmt::print("{}.{} [{}]\n  {}{}\n", s.module_kind, s.statistic, s.unit, s.meaning, s.formula.empty() ? "" : "\n  = " + s.formula);
  return 0;
}

int overview(const Parameters& parameters, bool json) {
  std::map<std::string, int> modules;
  for (const auto& [key, parameter] : parameters.all()) ++modules[module_of(key)];
  if (json) {
    Json document = {{"parameters", Json::array()}};
    for (const auto& [key, parameter] : parameters.all()) document["parameters"].push_back(to_json(parameter));
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("bumpsim describe NAME explains one of these:\n\nschemes\n");
  for (const Scheme* scheme : all_schemes()) fmt::print("  {:<20} {}\n", scheme->page().id, scheme->page().title);
  fmt::print("\nmodules and their parameters\n");
  for (const auto& [module, count] : modules) fmt::print("  {:<20} {} parameter{}\n", module, count, count == 1 ? "" : "s");
  fmt::print("\n  {:<20} what every reported number means\n", "statistics");
  return 0;
}

}  // namespace

int describe_command(const DescribeArguments& arguments) {
  const Parameters parameters = all_parameters();
  if (arguments.name.empty()) return overview(parameters, arguments.json);
  if (arguments.name == "statistics") return describe_statistics(arguments.json);
  std::set<std::string> names = {"statistics"};
  for (const Scheme* scheme : all_schemes()) {
    if (scheme->page().id == arguments.name) return describe_scheme(*scheme, arguments.json);
    names.insert(scheme->page().id);
  }
  for (const ShippedScene& scene : shipped_scenes()) {
    if (scene.name != arguments.name) {
      names.insert(scene.name);
      continue;
    }
    if (!arguments.json) fmt::print("{}\n", scene.title);
    return check_command({scene.name, arguments.json});
  }
  const auto below = parameters_below(parameters, arguments.name);
  if (!below.empty()) {
    if (arguments.json) {
      Json document = Json::array();
      for (const Parameter* p : below) document.push_back(to_json(*p));
      fmt::print("{}\n", document.dump(2));
    } else {
      print_parameters(below);
    }
    return 0;
  }
  for (const auto& [key, parameter] : parameters.all()) {
    names.insert(key);
    names.insert(module_of(key));
  }
  const std::string near = nearest_word(arguments.name, {names.begin(), names.end()});
  throw Error({"there is nothing called '" + arguments.name + "'", {}, "it is no scheme, scene, module or parameter", near.empty() ? "bumpsim describe" : "bumpsim describe " + near});
}

}  // namespace bump
