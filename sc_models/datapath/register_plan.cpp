#include "datapath/register_plan.h"

#include <algorithm>
#include <limits>

#include "datapath/invariant.h"

namespace bump {

RegisterPlan::RegisterPlan(const Netlist& netlist, const Schedule& schedule, int interval)
    : netlist_(netlist),
      schedule_(schedule),
      interval_(interval),
      fixed_(netlist.nodes().size(), false),
      last_(netlist.nodes().size(), -1),
      root_(netlist.nodes().size(), -1),
      parts_from_(netlist.nodes().size(), std::numeric_limits<int>::max()),
      bits_(netlist.nodes().size(), 0) {
  BUMP_ASSERT(schedule.start.size() == netlist.nodes().size() && interval >= 1);
  find_fixed();
  find_last_uses();
  const std::vector<Node>& nodes = netlist_.nodes();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) root_[at(i)] = is_view(i) ? root_[at(nodes[at(i)].operands[0])] : i;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
    if (root_[at(i)] == i && !fixed_[at(i)] && nodes[at(i)].op != Op::table) plan(i);
  std::stable_sort(registers_.begin(), registers_.end(), [](const HeldWord& a, const HeldWord& b) { return a.node < b.node; });
}

bool RegisterPlan::is_view(int node) const {
  switch (netlist_.nodes()[at(node)].op) {
    case Op::shift:
    case Op::negate:
    case Op::absolute:
    case Op::half_turn:
    case Op::is_negative:
    case Op::is_beyond_quarter:
      return true;
    case Op::clamp:
      return schedule_.finish[at(node)] == schedule_.start[at(node)];
    default:
      return false;
  }
}

void RegisterPlan::find_fixed() {
  const std::vector<Node>& nodes = netlist_.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<int>& operands = nodes[i].operands;
    fixed_[i] = nodes[i].op == Op::constant ||
                (!operands.empty() && std::all_of(operands.begin(), operands.end(), [&](int o) { return fixed_[at(o)]; }));
  }
}

void RegisterPlan::find_last_uses() {
  const std::vector<Node>& nodes = netlist_.nodes();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
    if (!is_view(i) && nodes[at(i)].op != Op::column)
      for (const int operand : nodes[at(i)].operands) use(operand, schedule_.start[at(i)]);
  for (const Netlist::Port& port : netlist_.outputs()) use(port.node, schedule_.latency);
}

void RegisterPlan::use(int node, int cycle) {
  int& last = last_[at(node)];
  last = std::max(last, cycle);
}

/// The first edge that the word crosses as it is, by the cycle behind it.
int RegisterPlan::first_edge(int node) const {
  const Node& n = netlist_.nodes()[at(node)];
  const int made_by = n.op == Op::column ? n.operands[0] : node;
  return schedule_.finish[at(node)] + (schedule_.finish[at(made_by)] > schedule_.start[at(made_by)] ? 0 : 1);
}

void RegisterPlan::plan(int root) {
  std::vector<int> views;
  int end = -1;
  for (int v = root; v < static_cast<int>(root_.size()); ++v) {
    if (root_[at(v)] != root) continue;
    views.push_back(v);
    end = std::max(end, last_[at(v)]);
  }
  const int width = netlist_.nodes()[at(root)].format.width;
  for (int cycle = first_edge(root); cycle <= end; cycle += interval_) {
    int parts = 0;
    for (const int v : views)
      if (last_[at(v)] >= cycle) parts += netlist_.nodes()[at(v)].format.width;
    bits_[at(root)] += std::min(parts, width);
    if (parts >= width) {
      registers_.push_back({root, cycle});
      continue;
    }
    parts_from_[at(root)] = std::min(parts_from_[at(root)], cycle);
    for (const int v : views)
      if (last_[at(v)] >= cycle) registers_.push_back({v, cycle});
  }
}

WordPlace RegisterPlan::place(int node, int cycle) const {
  if (fixed_[at(node)]) return {WordPlace::From::fixed, 0};
  const int root = root_[at(node)], first = first_edge(root);
  BUMP_ASSERT(cycle >= first - 1);
  if (cycle < first) return {node == root ? WordPlace::From::made : WordPlace::From::view, first - 1};
  const int edge = first + (cycle - first) / interval_ * interval_;
  if (edge >= parts_from_[at(root)]) {
    BUMP_ASSERT(last_[at(node)] >= edge);
    return {WordPlace::From::held, edge};
  }
  return {node == root ? WordPlace::From::held : WordPlace::From::view, edge};
}

}  // namespace bump
