#include <catch2/catch.hpp>

#include "../datapath/random_netlist.h"
#include "datapath/evaluate.h"
#include "datapath/inventory.h"
#include "datapath/register_plan.h"
#include "rtl/datapath_module.h"
#include "verilog_tools.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

OperatorLatencies random_latencies(Random& random) {
  OperatorLatencies l;
  l.adder = random.integer(0, 2);
  l.multiplier = random.integer(0, 3);
  l.table = random.integer(0, 3);
  l.clamp = random.integer(0, 2);
  l.shifter = random.integer(0, 2);
  l.divider_bits_per_cycle = random.integer(1, 5);
  l.square_root_bits_per_cycle = random.integer(1, 5);
  return l;
}

/// Words of the ports of `lanes` random evaluations: what the hardware is given and what it must give.
struct Words {
  std::vector<PortWords> in, out;
};
Words evaluate_words(const Netlist& netlist, Random& random, int lanes) {
  std::vector<std::vector<double>> inputs, outputs(netlist.outputs().size(), std::vector<double>(static_cast<std::size_t>(block_lanes)));
  for (const Netlist::Port& port : netlist.inputs()) {
    inputs.emplace_back();
    for (int lane = 0; lane < lanes; ++lane)
      inputs.back().push_back(random_value(random, netlist.nodes()[static_cast<std::size_t>(port.node)].format));
  }
  std::vector<const double*> in;
  std::vector<double*> out;
  for (const auto& values : inputs) in.push_back(values.data());
  for (auto& values : outputs) out.push_back(values.data());
  const auto evaluator = make_evaluator(netlist, Arithmetic::fixed);
  evaluator->evaluate(in.data(), lanes, out.data());
  Words words;
  for (int lane = 0; lane < lanes; ++lane) {
    words.in.emplace_back();
    words.out.emplace_back();
    for (const Netlist::Port& port : netlist.inputs()) words.in.back().push_back(evaluator->raw(port.node, lane));
    for (const Netlist::Port& port : netlist.outputs()) words.out.back().push_back(evaluator->raw(port.node, lane));
  }
  return words;
}

/// A datapath with shared multipliers, its phase counted from the first cycle on and its outputs kept for the interval, as a bench that
/// looks every cycle needs it.
VerilogModule keeper(const DatapathModule& module, int bits_of_phase) {
  std::string ports = "  input wire clk", connections = ".clk(clk), .phase(phase)", body;
  for (const DatapathModule::Port& port : module.inputs) {
    ports += ",\n  input wire " + verilog_range(port.format.width) + "in_" + port.verilog;
    connections += ", .in_" + port.verilog + "(in_" + port.verilog + ")";
  }
  const std::string last = verilog_word(module.initiation_interval - 1, bits_of_phase), first = verilog_word(0, bits_of_phase);
  body += "  reg " + verilog_range(bits_of_phase) + "phase;\n  initial phase = " + first +
          ";\n  always @(posedge clk) phase <= phase == " + last + " ? " + first + " : phase + 1'b1;\n";
  const std::string fresh = verilog_word(module.latency % module.initiation_interval, bits_of_phase);
  for (const DatapathModule::Port& port : module.outputs) {
    const std::string range = verilog_range(port.format.width), &name = port.verilog;
    ports += ",\n  output wire " + range + "out_" + name;
    connections += ", .out_" + name + "(now_" + name + ")";
    body += "  wire " + range + "now_" + name + ";\n  reg " + range + "kept_" + name + ";\n  always @(posedge clk) if (phase == " + fresh +
            ") kept_" + name + " <= now_" + name + ";\n  assign out_" + name + " = phase == " + fresh + " ? now_" + name + " : kept_" +
            name + ";\n";
  }
  const std::string name = module.name + "_kept";
  return {name, "module " + name + " (\n" + ports + "\n);\n" + body + "  " + module.name + " datapath (" + connections + ");\nendmodule\n"};
}

/// The datapath under the bench, a new cycle every clock: of an interval of several cycles the operands of the first count.
void add(IcarusBench& bench, const std::string& scheme, const Netlist& netlist, const Schedule& schedule, Random& random) {
  const DatapathModule module = datapath_module(scheme, "unit", netlist, schedule);
  if (module.has_clock != (module.latency > 0) && module.initiation_interval == 1) return;  // nothing but constants at the outputs
  bench.add({module.name, module.text});
  for (const VerilogModule& leaf : module.leaves) bench.add(leaf);
  for (const auto& [path, text] : module.roms) bench.add_file(path, text);
  Device device;
  device.name = module.name;
  device.stages = module.latency;
  const int interval = module.initiation_interval;
  if (interval > 1) {
    int bits = 1;
    while ((1 << bits) < interval) ++bits;
    bench.add(keeper(module, bits));
    device.name += "_kept";
    device.stages = std::max(1, device.stages);
  }
  for (const DatapathModule::Port& port : module.inputs) device.inputs.push_back({"in_" + port.verilog, port.format});
  for (const DatapathModule::Port& port : module.outputs) device.outputs.push_back({"out_" + port.verilog, port.format});
  const Words words = evaluate_words(netlist, random, 120);
  for (std::size_t cycle = 0; cycle < words.in.size(); ++cycle) {
    const std::size_t phase = cycle % static_cast<std::size_t>(interval);
    device.vectors.push_back(words.in[cycle]);
    device.expected.push_back(words.out[cycle - phase]);
  }
  bench.add(std::move(device));
}

}  // namespace

TEST_CASE("the Verilog of random netlists gives the words of the fixed-point evaluation, at the schedule's latency") {
  if (!is_there("iverilog")) return;
  Random random(1);
  IcarusBench bench;
  for (int i = 0; i < 60; ++i) {
    const Netlist netlist = random_netlist(random, random.integer(5, 40));
    const OperatorLatencies latencies = i % 4 == 0 ? OperatorLatencies{} : random_latencies(random);
    add(bench, "random" + std::to_string(i), netlist, schedule(netlist, latencies), random);
  }
  CHECK(bench.mismatches() == "");
  if (is_there("verilator")) CHECK(lint(bench.modules()) == "");
}

TEST_CASE("with shared multipliers the Verilog of random netlists gives the same words, once an interval") {
  if (!is_there("iverilog")) return;
  Random random(2);
  IcarusBench bench;
  int shared = 0;
  for (int i = 0; i < 80; ++i) {
    const Netlist netlist = random_netlist(random, random.integer(10, 50));
    OperatorLatencies latencies = random_latencies(random);
    latencies.multiplier = std::max(1, latencies.multiplier);
    const Schedule scheduled = schedule(netlist, latencies, random.integer(1, 3));
    if (scheduled.initiation_interval == 1) continue;
    ++shared;
    add(bench, "shared" + std::to_string(i), netlist, scheduled, random);
  }
  CHECK(shared > 20);
  CHECK(bench.mismatches() == "");
}

TEST_CASE("a word that is read late goes on as the parts that are read, when those are narrower") {
  Netlist n("unit");
  const Wire wide = n.input("wide", sfixed(12, 10)), other = n.input("other", sfixed(12, 10));
  const Wire sum = n.add("sum", wide, other, sfixed(12, 10)), twice = n.add("twice", sum, sum, sfixed(12, 10));
  n.output("y", n.select("y", n.is_negative("sign", wide), twice, sum, sfixed(12, 10)));
  const DatapathModule module = datapath_module("parts", "unit", n, schedule(n, OperatorLatencies{}));
  // sign over two edges, sum in cycles 1 and 2, twice in cycle 2
  CHECK(module.register_bits == 2 * 1 + 2 * 12 + 12);
  CHECK_THAT(module.text, Contains("reg [0:0] sign_c1;") && Contains("reg [0:0] sign_c2;") && !Contains("wide_c1"));
}

TEST_CASE("operators of constants alone are named as such") {
  Netlist n("unit");
  const Wire two = n.constant("two", 2, ufixed(4, 0));
  n.output("y", n.add("y", n.input("x", ufixed(4, 0)), n.mul("four", two, two, ufixed(4, 0)), ufixed(5, 0)));
  const DatapathModule module = datapath_module("folded", "unit", n, schedule(n, OperatorLatencies{}));
  CHECK(module.folded == std::vector<std::string>{"four"});
}
