// `bumpsim probe`: one unit's netlist on given inputs, every node by name, in double precision and in fixed point. Angles are given and
// printed in degrees.

#include "datapath/probe.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/scheme_units.h"

namespace bump {

namespace {

constexpr double degrees_per_turn = 360;

const Format* input_format(const Netlist& netlist, const std::string& name) {
  for (const Netlist::Port& port : netlist.inputs())
    if (port.name == name) return &netlist.nodes()[static_cast<std::size_t>(port.node)].format;
  return nullptr;
}

/// "name=value" pairs; degrees become turns where the input is an angle.
std::map<std::string, double> read_inputs(const Netlist& netlist, const std::vector<std::string>& assignments) {
  std::map<std::string, double> inputs;
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Error({"'" + assignment + "' is not an input", {}, "an input is given as name=value", "bumpsim probe SCHEME UNIT L.phi=40"});
    const std::string name = assignment.substr(0, equals), text = assignment.substr(equals + 1);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value))
      throw Error({"'" + text + "' is not a number", {}, "it was given for input " + name, name + "=1.5"});
    if (!inputs.emplace(name, value).second) throw Error({"input " + name + " is given twice"});
    const Format* format = input_format(netlist, name);
    if (format != nullptr && format->is_angle) inputs[name] = value / degrees_per_turn;
  }
  return inputs;
}

double shown(const ProbeRow& row, double value) { return row.is_angle ? value * degrees_per_turn : value; }

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  const std::string text = fmt::format("{:.6f}", value);
  return text == "-0.000000" ? text.substr(1) : text;
}

nlohmann::ordered_json to_json(const ProbeRow& row) {
  nlohmann::ordered_json entry = {{"name", row.name}, {"operator", row.op}, {"equation", row.equation}, {"format", row.format}};
  entry["unit"] = row.is_angle ? "degrees" : "";
  const auto value = [](double v) { return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr); };
  entry["double"] = value(shown(row, row.real));
  if (row.format != "real") {
    entry["fixed"] = value(shown(row, row.fixed));
    entry["word"] = row.raw;
  }
  entry["addition"] = row.addition;
  return entry;
}

}  // namespace

int probe_command(const ProbeArguments& arguments) {
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  const Scheme& scheme = find_scheme(arguments.scheme);
  const Design design = scheme.design(configuration, Material{});
  const Netlist& netlist = unit_of(design, arguments.scheme, arguments.unit);
  const std::vector<ProbeRow> rows = probe(netlist, read_inputs(netlist, arguments.assignments));

  if (arguments.json) {
    nlohmann::ordered_json document = {{"scheme", arguments.scheme}, {"unit", arguments.unit}, {"nodes", nlohmann::ordered_json::array()}};
    for (const ProbeRow& row : rows) document["nodes"].push_back(to_json(row));
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("{:<22} {:<18} {:>12} {:>14} {:>14} {:>10}  {}\n", "node", "operator", "format", "double", "fixed", "word", "source");
  for (const ProbeRow& row : rows) {
    const bool real = row.format == "real";
    const std::string source = row.equation + (row.addition ? " (beside the published design)" : "");
    fmt::print("{:<22} {:<18} {:>12} {:>14} {:>14} {:>10} {}{}\n", row.name, row.op, row.format, number(shown(row, row.real)),
               real ? "" : number(shown(row, row.fixed)), real ? "" : std::to_string(row.raw), row.is_angle ? "deg " : "    ", source);
  }
  fmt::print("Angles are in degrees, [-180, 180). `word` is the integer that the hardware holds; a table's is its address.\n");
  return 0;
}

}  // namespace bump
