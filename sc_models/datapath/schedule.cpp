#include "datapath/schedule.h"

#include <algorithm>
#include <numeric>

#include "datapath/arithmetic.h"
#include "datapath/checks.h"
#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

int quotient_up(int a, int b) {
  return (a + b - 1) / b;
}

void check_latencies(const OperatorLatencies& latencies, int multiplier_limit) {
  const auto check = [](int value, int low, const std::string& name) {
    if (value < low)
      throw Error(
          {name + " is " + std::to_string(value), {}, "a pipeline cannot have that", "a number from " + std::to_string(low) + " upwards"});
  };
  check(latencies.adder, 0, "the latency of adders");
  check(latencies.multiplier, 0, "the latency of multipliers");
  check(latencies.table, 0, "the latency of tables");
  check(latencies.clamp, 0, "the latency of clamps");
  check(latencies.shifter, 0, "the latency of barrel shifters");
  check(latencies.divider_bits_per_cycle, 1, "the number of quotient bits a cycle");
  check(latencies.square_root_bits_per_cycle, 1, "the number of root bits a cycle");
  check(multiplier_limit, 0, "the limit on multipliers");
}

int operands_ready(const Node& node, const std::vector<int>& finish) {
  int ready = 0;
  for (const int operand : node.operands) ready = std::max(ready, finish[static_cast<std::size_t>(operand)]);
  return ready;
}

/// Cycle in which each node could start if every operator were its own hardware.
std::vector<int> depths(const Netlist& netlist, const OperatorLatencies& latencies) {
  std::vector<int> start, finish;
  for (const Node& node : netlist.nodes()) {
    start.push_back(operands_ready(node, finish));
    finish.push_back(start.back() + latency_of(node, latencies));
  }
  return start;
}

}  // namespace

int latency_of(const Node& node, const OperatorLatencies& latencies) {
  switch (node.op) {
    case Op::add:
    case Op::sub:
    case Op::add_sub:
      return latencies.adder;
    case Op::mul:
      return latencies.multiplier;
    case Op::div:
      return quotient_up(magnitude_bits(node.format), latencies.divider_bits_per_cycle);
    case Op::sqrt:
      return quotient_up(magnitude_bits(node.format), latencies.square_root_bits_per_cycle);
    case Op::table:
      return latencies.table;  // the index encoder of a floating index is part of it
    case Op::clamp:
      return latencies.clamp;
    case Op::shift_by:
      return latencies.shifter;
    default:
      return 0;
  }
}

Schedule schedule(const Netlist& netlist, const OperatorLatencies& latencies, int multiplier_limit) {
  check_latencies(latencies, multiplier_limit);
  const std::vector<Node>& nodes = netlist.nodes();
  for (const Node& node : nodes)
    require(!node.format.is_real, "netlist '" + netlist.name() + "', node '" + node.name + "': a real value has no place in a pipeline");

  const auto products = static_cast<int>(std::count_if(nodes.begin(), nodes.end(), [](const Node& node) { return node.op == Op::mul; }));
  const int limit = multiplier_limit == 0 ? products : multiplier_limit;
  Schedule result;
  result.initiation_interval = products == 0 ? 1 : quotient_up(products, limit);
  result.start.resize(nodes.size());
  result.finish.resize(nodes.size());

  // In order of depth; at equal depth in recorded order, which keeps operands in front of their readers when an operator takes no time.
  const std::vector<int> depth = depths(netlist, latencies);
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });

  std::vector<int> taken(static_cast<std::size_t>(result.initiation_interval), 0);  // multipliers busy in each cycle modulo the interval
  for (const std::size_t i : order) {
    int start = operands_ready(nodes[i], result.finish);
    if (nodes[i].op == Op::mul) {
      while (taken[static_cast<std::size_t>(start % result.initiation_interval)] >= limit) ++start;
      ++taken[static_cast<std::size_t>(start % result.initiation_interval)];
    }
    result.start[i] = start;
    result.finish[i] = start + latency_of(nodes[i], latencies);
  }
  for (const Netlist::Port& port : netlist.outputs())
    result.latency = std::max(result.latency, result.finish[static_cast<std::size_t>(port.node)]);

  result.multipliers_built = *std::max_element(taken.begin(), taken.end());
  BUMP_ASSERT(result.multipliers_built <= limit);
  BUMP_ASSERT(std::accumulate(taken.begin(), taken.end(), 0) == products);
  for (std::size_t i = 0; i < nodes.size(); ++i) BUMP_ASSERT(result.start[i] >= operands_ready(nodes[i], result.finish));
  return result;
}

}  // namespace bump
