#pragma once
// Shares buffers between the nodes of a netlist, as a compiler shares registers: steps run in order, and a slot is free again after the
// last step that reads its node. A result never takes the slot of an operand of the same step.

#include <functional>
#include <vector>

namespace bump {

class SlotPlan {
 public:
  explicit SlotPlan(std::size_t nodes) : held_(nodes, false) {}

  /// The node's slot is never shared.
  void hold(int node) { held_[static_cast<std::size_t>(node)] = true; }
  /// The next step makes and reads these nodes; what it reads, a step before has made.
  void step(std::vector<int> made, std::vector<int> read) { steps_.push_back({std::move(made), std::move(read)}); }

  /// A slot for every node that a step makes, -1 for others; `kind` numbers pools of slots from 0, and slots count within their pool.
  std::vector<int> assign(const std::function<int(int node)>& kind);
  /// After assign(): the size of a pool.
  int slots(int kind) const { return static_cast<std::size_t>(kind) < sizes_.size() ? sizes_[static_cast<std::size_t>(kind)] : 0; }

 private:
  struct Step {
    std::vector<int> made, read;
  };

  std::vector<bool> held_;
  std::vector<Step> steps_;
  std::vector<int> sizes_;
};

}  // namespace bump
