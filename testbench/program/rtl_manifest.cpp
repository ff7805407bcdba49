#include "testbench/program/rtl_manifest.h"

#include <fmt/core.h>

#include "datapath/invariant.h"
#include "testbench/program/rtl_folder.h"
#include "testbench/program/shell_word.h"
#include "testbench/program/version.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

Json to_json(const std::vector<DatapathModule::Port>& ports, const std::string& prefix) {
  Json list = Json::array();
  for (const DatapathModule::Port& port : ports)
    list.push_back(
        {{"name", port.name}, {"port", prefix + port.verilog}, {"format", to_string(port.format)}, {"width", port.format.width}});
  return list;
}

Json modules_of(const EmittedUnit& unit) {
  Json modules = {unit.wrapper.module.name, unit.datapath.name};
  for (const VerilogModule& leaf : unit.datapath.leaves) modules.push_back(leaf.name);
  return modules;
}

Json built_of(const EmittedUnit& unit) {
  const Inventory& built = unit.built;
  return {{"multipliers", unit.schedule.multipliers_built},
          {"products", built.multipliers},
          {"adders", built.adders},
          {"dividers", built.dividers},
          {"square_roots", built.square_roots},
          {"tables", built.tables},
          {"maps", built.maps},
          {"second_ports", built.second_ports},
          {"shifters", built.shifters},
          {"clamps", built.clamps},
          {"selects", built.selects},
          {"table_bits", built.table_bits},
          {"distinct_table_bits", built.distinct_table_bits}};
}

Json to_json(const EmittedUnit& unit) {
  Json entry = {{"unit", unit.wrapper.unit}, {"top", unit.wrapper.module.name}, {"modules", modules_of(unit)}};
  entry["roms"] = Json::array();
  for (const auto& [path, text] : unit.datapath.roms) entry["roms"].push_back(path);
  entry["inputs"] = to_json(unit.wrapper.inputs, "in_");
  entry["outputs"] = to_json(unit.wrapper.outputs, "out_");
  entry["latency"] = unit.wrapper.latency;
  entry["initiation_interval"] = unit.wrapper.initiation_interval;
  entry["capacity"] = unit.wrapper.capacity;
  entry["built"] = built_of(unit);
  entry["folded"] = unit.datapath.folded;
  entry["cells"] = {{"module", unit.cells.module}};
  for (const ExpectedCells::Kind& kind : unit.cells.kinds) entry["cells"][kind.name] = {{"types", kind.patterns}, {"count", kind.count}};
  const WrapperRegisters wrapper = wrapper_registers(unit.wrapper, unit.datapath);
  entry["register_bits"] = {{"between_operators", unit.datapath.register_bits},
                            {"inside_operators", unit.datapath.inside_bits},
                            {"control", wrapper.control},
                            {"entry", wrapper.entry},
                            {"result", wrapper.result},
                            {"completion_queue", wrapper.queue}};
  return entry;
}

Json to_json(const ParameterValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

/// What is not as declared, in the order of keys.
Json changes_of(const Configuration& configuration) {
  Json changes = Json::object();
  for (const auto& [key, entry] : configuration.entries()) {
    const Parameter* parameter = configuration.parameters().find(key);
    BUMP_ASSERT(parameter != nullptr);
    if (entry.value != parameter->fallback) changes[key] = to_json(entry.value);
  }
  return changes;
}

}  // namespace

Json rtl_manifest(const Emission& emission, const Configuration& configuration, const EmissionOptions& options) {
  Json document = {{"schema", rtl_schema}, {"schema_version", schema_version}, {"version", version_text()}, {"scheme", emission.scheme}};
  document["configuration"] = changes_of(configuration);
  document["scene"] = options.scene.empty() ? Json(nullptr) : Json(options.scene);
  document["vectors"] = options.vectors;
  document["seed"] = options.seed;
  document["units"] = Json::array();
  for (const EmittedUnit& unit : emission.units) document["units"].push_back(to_json(unit));
  document["files"] = Json::array();
  for (const auto& [path, text] : emission.files) document["files"].push_back(path);
  return document;
}

std::string rtl_summary(const Emission& emission) {
  std::string text;
  for (const EmittedUnit& unit : emission.units) {
    text += fmt::format("{}: latency {}, interval {}, capacity {};", unit.wrapper.module.name, unit.wrapper.latency,
                        unit.wrapper.initiation_interval, unit.wrapper.capacity);
    for (const ExpectedCells::Kind& kind : unit.cells.kinds)
      text += fmt::format("{} {} {}", &kind == &unit.cells.kinds.front() ? "" : ",", kind.count, kind.name);
    text += "\n";
  }
  return text;
}

std::string rtl_readme(const Emission& emission, const Configuration& configuration, const EmissionOptions& options) {
  const Json changed = changes_of(configuration);
  std::string changes = options.scene.empty() ? "" : " --scene " + shell_word(options.scene);
  for (const std::string& unit : options.units) changes += " --unit " + unit;
  for (const auto& [key, value] : changed.items())
    changes += fmt::format(" --set {}={}", key, to_string(configuration.entries().at(key).value));
  std::string units;
  for (const EmittedUnit& unit : emission.units)
    units += fmt::format("| `{}` | {} | {} | {} | {} |\n", unit.wrapper.module.name, unit.wrapper.latency, unit.wrapper.initiation_interval,
                         unit.wrapper.inputs.size(), unit.wrapper.outputs.size());
  return fmt::format(R"(# {0} in Verilog

Written by {1}: `bumpsim rtl {0}{2}`.

| unit | latency, cycles | initiation interval, cycles | operands | results |
|--|--|--|--|--|
{3}
A unit takes a token at the clock edge that ends a cycle with `in_valid` and `in_ready`, and delivers it at that of one with `out_valid` and `out_ready`, in
order. It never stalls inside: `CAPACITY` credits in front guarantee room in a completion queue of as many words behind. Words are fixed point; `rtl.json`
has the format of every port (`s12.10`: signed, 12 bits, 10 of them behind the point), the inventory, and the cells that Yosys must find.

| folder | holds |
|--|--|
| `rtl/` | Verilog-2001, one module to a file: the unit, its datapath, and a module for every kind of divider, square root, adder-subtractor and table |
| `rom/` | ROM images, read by `$readmemh` relative to this folder |
| `test/` | vectors (one a line, operands and results side by side, the first port in the highest bits), test benches, a harness in C++, Yosys scripts |

Every check runs in this folder, needs `make` and the tool that it names, and fails if anything differs:

    make lint                     # Verilator: no warning in any module
    make test                     # Icarus Verilog: the test benches
    make verilate                 # Verilator: the same checks, fast; also VECTORS=100 SEED=7 CAPACITY=3
    make counts                   # Yosys: operators and tables as counted

`make test` and `make verilate` send every vector twice, without pauses and with random ones on both sides, then some again between resets, and compare every word, and in every cycle
`in_ready` and `out_valid` with the recurrences that stand in front of the unit's module. More vectors: `bumpsim rtl --vectors`.
)",
                     emission.scheme, version_text(), changes, units);
}

}  // namespace bump
