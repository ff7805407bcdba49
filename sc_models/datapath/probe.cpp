#include "datapath/probe.h"

#include <algorithm>

#include "datapath/error.h"
#include "datapath/evaluate.h"

namespace bump {

namespace {

std::string ports_of(const Netlist& netlist) {
  std::string text;
  for (const Netlist::Port& port : netlist.inputs())
    text += (text.empty() ? "" : ", ") + port.name + " (" + to_string(netlist.nodes()[static_cast<std::size_t>(port.node)].format) + ")";
  return text;
}

void check_names(const Netlist& netlist, const std::map<std::string, double>& inputs) {
  const auto is_port = [&](const std::string& name) {
    return std::any_of(netlist.inputs().begin(), netlist.inputs().end(), [&](const Netlist::Port& port) { return port.name == name; });
  };
  for (const auto& [name, value] : inputs)
    if (!is_port(name))
      throw Error({"unit '" + netlist.name() + "' has no input '" + name + "'", {}, "", "its inputs: " + ports_of(netlist)});
  std::string missing;
  for (const Netlist::Port& port : netlist.inputs())
    if (inputs.count(port.name) == 0) missing += (missing.empty() ? "" : ", ") + port.name;
  if (!missing.empty())
    throw Error({"unit '" + netlist.name() + "' needs a value for " + missing,
                 {},
                 "every input must be given",
                 "its inputs: " + ports_of(netlist)});
}

void evaluate_one(const Netlist& netlist, const std::map<std::string, double>& inputs, Evaluator& evaluator) {
  std::vector<const double*> in;
  for (const Netlist::Port& port : netlist.inputs()) in.push_back(&inputs.at(port.name));
  std::vector<double> results(netlist.outputs().size());
  std::vector<double*> out;
  for (double& result : results) out.push_back(&result);
  evaluator.evaluate(in.data(), 1, out.data());
}

}  // namespace

std::vector<ProbeRow> probe(const Netlist& netlist, const std::map<std::string, double>& inputs) {
  check_names(netlist, inputs);
  const std::vector<Node>& nodes = netlist.nodes();
  const bool has_words = std::none_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.format.is_real; });
  const auto real = make_evaluator(netlist, Arithmetic::real);
  evaluate_one(netlist, inputs, *real);
  const auto fixed = has_words ? make_evaluator(netlist, Arithmetic::fixed) : nullptr;
  if (fixed) evaluate_one(netlist, inputs, *fixed);

  std::vector<ProbeRow> rows;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    const Node& node = nodes[static_cast<std::size_t>(i)];
    ProbeRow row;
    row.name = node.name;
    row.op = name_of(node.op);
    row.equation = node.equation;
    row.format = to_string(node.format);
    row.real = real->value(i, 0);
    row.fixed = fixed ? fixed->value(i, 0) : row.real;
    row.raw = fixed ? fixed->raw(i, 0) : 0;
    row.addition = node.addition;
    row.is_angle = node.format.is_angle;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace bump
