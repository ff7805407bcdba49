#include "testbench/cosimulation/plan.h"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "datapath/invariant.h"
#include "rtl/unit_module.h"
#include "system/pipeline_timing.h"
#include "testbench/cosimulation/cosimulation.h"
#include "testbench/scene/only_material.h"
#include "units/colour_unit.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

std::string macro(const std::string& name, const std::vector<DatapathModule::Port>& ports, const std::string& prefix) {
  std::string text = fmt::format("#define {}(DO)", name);
  for (const auto& port : ports) text += fmt::format(" \\\n  DO({}{}, \"{}\", {})", prefix, port.verilog, port.name, port.format.width);
  return text + "\n";
}

std::string ports_header(const RtlUnit& unit) {
  return fmt::format("// Ports of {}: pin, the netlist's name, width in bits.\n#pragma once\n{}{}", unit.module.name,
                     macro("UNIT_OPERANDS", unit.inputs, "in_"), macro("UNIT_RESULTS", unit.outputs, "out_"));
}

PlannedUnit plan_unit(const std::string& scheme, const Netlist& netlist, const Schedule& schedule, const StageSpec& stage,
                      const Configuration& configuration) {
  const DatapathModule datapath = datapath_module(scheme, stage.name, netlist, schedule);
  const RtlUnit wrapper = unit_module(scheme, stage.name, datapath, static_cast<int>(configuration.integer(stage.name + ".capacity")));
  PlannedUnit unit;
  unit.unit = stage.name;
  unit.top = wrapper.module.name;
  unit.capacity = stage.capacity;
  unit.tail = stage.latency - wrapper.latency;
  BUMP_ASSERT(unit.tail >= 0);
  unit.ports = ports_header(wrapper);
  unit.files = datapath.roms;
  unit.files["rtl/" + unit.top + ".v"] = wrapper.module.text;
  unit.files["rtl/" + datapath.name + ".v"] = datapath.text;
  for (const VerilogModule& leaf : datapath.leaves) unit.files["rtl/" + leaf.name + ".v"] = leaf.text;
  return unit;
}

std::optional<std::string> text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::vector<PlannedUnit> plan_units(const Scene& scene, const Scheme& scheme, const Configuration& configuration) {
  check_cosimulation(scene, scheme, configuration);
  const Material& material = only_material(scene);
  const Design design = scheme.design(configuration, material);
  const Netlist colour = colour_netlist(scene, material, ColourUnitConfig(configuration),
                                        design.light_maps ? LightSum::in_light_maps : LightSum::in_colour_unit);
  const PipelineTiming timing = make_pipeline_timing(make_schedules(design, colour, configuration), 1, configuration);
  std::vector<PlannedUnit> units;
  const auto add = [&](const Netlist& netlist, const Schedule& schedule, stage::Index stage) {
    if (netlist.inputs().empty() || netlist.outputs().empty()) return;
    units.push_back(plan_unit(scheme.page().id, netlist, schedule, timing.at(stage), configuration));
  };
  add(design.environment, timing.schedules.environment, stage::environment);
  add(design.illumination, timing.schedules.illumination, stage::illumination);
  return units;
}

void check_emitted(const std::vector<PlannedUnit>& units, const std::string& folder) {
  for (const PlannedUnit& unit : units)
    for (const auto& [path, text] : unit.files) {
      const fs::path file = fs::path(folder) / path;
      const std::optional<std::string> found = text_of_file(file);
      if (found == text) continue;
      throw Error({"the folder holds other Verilog than this scheme, scene and configuration have",
                   {file.string()},
                   found ? "it differs" : "the file is not there",
                   "bumpsim rtl with the same scheme, --scene and --set"});
    }
}

}  // namespace bump
