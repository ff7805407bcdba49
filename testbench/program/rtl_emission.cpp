#include "testbench/program/rtl_emission.h"

#include <algorithm>

#include "datapath/invariant.h"
#include "datapath/sha256.h"
#include "rtl/harness.h"
#include "rtl/makefile.h"
#include "rtl/test_bench.h"
#include "rtl/unit_vectors.h"
#include "system/pipeline_timing.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/scheme_units.h"

namespace bump {

namespace {

/// A netlist that only names words for others is no hardware.
bool is_hardware(const NamedNetlist& unit) {
  return unit.is_datapath && !unit.netlist->inputs().empty() && !unit.netlist->outputs().empty();
}

std::vector<NamedNetlist> chosen_units(const Design& design, const std::string& scheme, const std::vector<std::string>& names) {
  const std::vector<NamedNetlist> all = units_of(design);
  std::string hardware;
  for (const NamedNetlist& unit : all)
    if (is_hardware(unit)) hardware += (hardware.empty() ? "" : ", ") + unit.name;
  for (const std::string& name : names) {
    const auto unit = std::find_if(all.begin(), all.end(), [&](const NamedNetlist& known) { return known.name == name; });
    if (name == "conversion") unit_of(design, scheme, name);  // says why there may be none
    if (unit == all.end())
      throw Error({"scheme " + scheme + " has no unit '" + name + "'", {}, "what becomes Verilog is: " + hardware, hardware});
    if (!is_hardware(*unit))
      throw Error({"unit " + name + " of " + scheme + " is no datapath",
                   {},
                   unit->is_datapath ? "it has no operands or no results" : "it is a program, in floating point",
                   hardware});
  }
  std::vector<NamedNetlist> units;
  for (const NamedNetlist& unit : all)
    if (is_hardware(unit) && (names.empty() || std::find(names.begin(), names.end(), unit.name) != names.end())) units.push_back(unit);
  return units;
}

/// Those that share multipliers, and how many.
int multiplier_limit(const std::string& unit, const Configuration& configuration) {
  const std::string stage = unit == "light_map_address" ? "light_map_fetch" : unit;
  return static_cast<int>(configuration.integer(stage + ".multipliers"));
}

/// 0: by latency. Units inside another stage have no capacity of their own.
int capacity(const std::string& unit, const Configuration& configuration) {
  if (unit != "environment" && unit != "illumination") return 0;
  return static_cast<int>(configuration.integer(unit + ".capacity"));
}

/// Units may share modules and ROMs.
void add_file(Emission& emission, const std::string& path, const std::string& text) {
  const auto [file, added] = emission.files.emplace(path, text);
  BUMP_ASSERT(added || file->second == text);
}

void add_unit(Emission& emission, const NamedNetlist& named, const Configuration& configuration, const EmissionOptions& options) {
  const OperatorLatencies latencies = operator_latencies(configuration);
  EmittedUnit unit;
  unit.schedule = schedule(*named.netlist, latencies, multiplier_limit(named.name, configuration));
  unit.built = count(*named.netlist);
  unit.datapath = datapath_module(emission.scheme, named.name, *named.netlist, unit.schedule);
  unit.wrapper = unit_module(emission.scheme, named.name, unit.datapath, capacity(named.name, configuration));
  unit.cells = expected_cells(*named.netlist, unit.schedule, unit.datapath);

  add_file(emission, "rtl/" + unit.wrapper.module.name + ".v", unit.wrapper.module.text);
  add_file(emission, "rtl/" + unit.datapath.name + ".v", unit.datapath.text);
  for (const VerilogModule& leaf : unit.datapath.leaves) add_file(emission, "rtl/" + leaf.name + ".v", leaf.text);
  for (const auto& [path, text] : unit.datapath.roms) add_file(emission, path, text);
  const std::string test = "test/" + named.name;
  add_file(emission, test + ".hex", unit_vectors(*named.netlist, options.vectors, options.seed));
  add_file(emission, test + "_tb.v", test_bench(unit.wrapper, options.vectors));
  add_file(emission, test + "_ports.h", harness_ports(unit.wrapper));
  add_file(emission, test + ".ys", yosys_script(unit.wrapper, unit.cells));
  emission.units.push_back(std::move(unit));
}

}  // namespace

Emission emit(const Scheme& scheme, const Configuration& configuration, const EmissionOptions& options) {
  if (configuration.choice("numeric") == "double")
    throw Error({"double precision has no hardware", configuration.entries().at("numeric").origin,
                 "Verilog is made of the fixed-point datapaths", "numeric=fixed"});
  const Design design = scheme.design(configuration, options.material);
  Emission emission;
  emission.scheme = scheme.page().id;
  std::vector<RtlUnit> wrappers;
  for (const NamedNetlist& unit : chosen_units(design, emission.scheme, options.units)) {
    add_unit(emission, unit, configuration, options);
    wrappers.push_back(emission.units.back().wrapper);
    stop_if_interrupted();
  }
  std::string digests;  // as sha256sum writes and checks them
  for (const auto& [path, text] : emission.files)
    if (path.rfind("rom/", 0) == 0) digests += sha256_hex(text.data(), text.size()) + "  " + path + "\n";
  add_file(emission, "test/roms.sha256", digests);
  add_file(emission, "test/harness.cpp", harness_text());
  add_file(emission, "Makefile", makefile_text(emission.scheme, wrappers));
  return emission;
}

}  // namespace bump
