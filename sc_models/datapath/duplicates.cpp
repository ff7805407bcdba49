#include "datapath/duplicates.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace bump {

namespace {

/// Everything that decides what a node computes; operands by their first equal.
auto key_of(const Netlist& netlist, const Node& node, std::vector<int> operands) {
  if (node.op == Op::add || node.op == Op::mul || node.op == Op::exclusive_or) std::sort(operands.begin(), operands.end());
  const Format& f = node.format;
  const std::string table = node.table < 0 ? "" : netlist.tables()[static_cast<std::size_t>(node.table)]->name;
  const std::string port = node.op == Op::input ? node.name : "";
  return std::make_tuple(node.op, std::move(operands), f.width, f.fraction, f.is_signed, f.is_angle, f.is_real, node.amount, table, port,
                         node.value, node.low, node.high);
}

bool is_operator(Op op) {
  return op != Op::input && op != Op::constant && op != Op::column;
}

}  // namespace

std::vector<std::pair<int, int>> equal_nodes(const Netlist& netlist) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> first;
  std::map<decltype(key_of(netlist, Node{}, {})), int> seen;
  for (const Node& node : netlist.nodes()) {
    const int self = static_cast<int>(first.size());
    std::vector<int> operands;
    for (const int operand : node.operands) operands.push_back(first[static_cast<std::size_t>(operand)]);
    const int original = seen.emplace(key_of(netlist, node, std::move(operands)), self).first->second;
    first.push_back(original);
    if (original != self && is_operator(node.op)) pairs.emplace_back(original, self);
  }
  return pairs;
}

}  // namespace bump
