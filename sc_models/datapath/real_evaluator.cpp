// Double-precision evaluation: the algorithm itself. Full-turn angles wrap, nothing else is rounded; tables call their functions.

#include <array>
#include <cmath>

#include "datapath/evaluators.h"
#include "datapath/invariant.h"
#include "datapath/lane_math.h"

namespace bump {

namespace {

using Lane = std::array<double, block_lanes>;

template <class Function>
void each(int lanes, Lane& out, const Function& function) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(lanes); ++i) out[i] = function(i);
}

class RealEvaluator : public Evaluator {
 public:
  explicit RealEvaluator(const Netlist& netlist) : netlist_(netlist), lanes_(netlist.nodes().size()) {
    for (std::size_t i = 0; i < netlist.nodes().size(); ++i) {
      const Node& node = netlist.nodes()[i];
      if (node.op == Op::constant) lanes_[i].fill(wrap_turns(node.value, node.format));
    }
  }

  void evaluate(const double* const* inputs, int lanes, double* const* outputs) override {
    BUMP_ASSERT(lanes >= 0 && lanes <= block_lanes);
    const std::vector<Node>& nodes = netlist_.nodes();
    std::size_t port = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].op == Op::constant) continue;
      if (nodes[i].op == Op::input) {
        const double* values = inputs[port++];  // ports are in the order of their nodes
        each(lanes, lanes_[i], [&](std::size_t j) { return values[j]; });
      } else {
        run(nodes[i], lanes, lanes_[i]);
      }
      if (nodes[i].format.wraps()) each(lanes, lanes_[i], [&](std::size_t j) { return to_half_open_turn(lanes_[i][j]); });
    }
    for (std::size_t i = 0; i < netlist_.outputs().size(); ++i) {
      const Lane& lane = lanes_[static_cast<std::size_t>(netlist_.outputs()[i].node)];
      for (std::size_t j = 0; j < static_cast<std::size_t>(lanes); ++j) outputs[i][j] = lane[j];
    }
  }

  double value(int node, int lane) const override { return lanes_[static_cast<std::size_t>(node)][static_cast<std::size_t>(lane)]; }

  std::int64_t raw(int, int) const override {
    const bool evaluates_words = false;
    BUMP_ASSERT(evaluates_words);
    return 0;
  }

 private:
  void run(const Node& node, int lanes, Lane& out) const {
    const auto operand = [&](std::size_t j) -> const Lane& { return lanes_[static_cast<std::size_t>(node.operands[j])]; };
    const Lane& a = operand(0);
    const Lane& b = node.operands.size() > 1 ? operand(1) : a;
    const Lane& c = node.operands.size() > 2 ? operand(2) : a;
    switch (node.op) {
      case Op::add:
        return each(lanes, out, [&](std::size_t i) { return a[i] + b[i]; });
      case Op::join:
        return each(lanes, out, [&](std::size_t i) { return a[i] + b[i]; });
      case Op::sub:
        return each(lanes, out, [&](std::size_t i) { return a[i] - b[i]; });
      case Op::mul:
        return each(lanes, out, [&](std::size_t i) { return a[i] * b[i]; });
      case Op::div:
        return each(lanes, out, [&](std::size_t i) { return a[i] / b[i]; });
      case Op::sqrt:
        return each(lanes, out, [&](std::size_t i) { return std::sqrt(a[i]); });
      case Op::table: {
        const bool turns = netlist_.tables()[static_cast<std::size_t>(node.table)]->index.wraps();
        return each(lanes, out, [&](std::size_t i) { return turns ? to_half_open_turn(a[i]) : a[i]; });
      }
      case Op::column: {
        const Node& read = netlist_.nodes()[static_cast<std::size_t>(node.operands[0])];
        const Table& table = *netlist_.tables()[static_cast<std::size_t>(read.table)];
        const Column& column = table.columns[static_cast<std::size_t>(node.amount)];
        if (!table.is_map()) return each(lanes, out, [&](std::size_t i) { return column.function(a[i]); });
        return each(lanes, out, [&](std::size_t i) {
          std::array<double, 3> index{a[i]};
          for (std::size_t j = 1; j < read.operands.size(); ++j)
            index[j] = wrap_turns(lanes_[static_cast<std::size_t>(read.operands[j])][i], table.fields[j - 1].index);
          return column.map_function(index.data());
        });
      }
      case Op::shift: {
        const double scale = std::ldexp(1.0, node.amount);
        return each(lanes, out, [&](std::size_t i) { return a[i] * scale; });
      }
      case Op::negate:
        return each(lanes, out, [&](std::size_t i) { return -a[i]; });
      case Op::absolute:
        return each(lanes, out, [&](std::size_t i) { return std::fabs(a[i]); });
      case Op::half_turn:
        return each(lanes, out, [&](std::size_t i) { return a[i] + 0.5; });
      case Op::clamp: {
        // Comparisons ordered so that 0/0 goes to the upper bound, as the all-ones quotient of the hardware does.
        const double low = node.low, high = node.high;
        return each(lanes, out, [&](std::size_t i) {
          const double below = a[i] < high ? a[i] : high;
          return below > low ? below : low;
        });
      }
      case Op::select:
        return each(lanes, out, [&](std::size_t i) { return a[i] != 0.0 ? b[i] : c[i]; });
      case Op::is_negative:
        return each(lanes, out, [&](std::size_t i) { return a[i] < 0.0 ? 1.0 : 0.0; });
      case Op::is_beyond_quarter:
        return each(lanes, out, [&](std::size_t i) { return a[i] > 0.25 || a[i] < -0.25 ? 1.0 : 0.0; });
      case Op::input:
      case Op::constant:
        return;
    }
  }

  const Netlist& netlist_;
  std::vector<Lane> lanes_;  ///< values per node; table nodes hold the index
};

}  // namespace

std::unique_ptr<Evaluator> make_real_evaluator(const Netlist& netlist) {
  return std::make_unique<RealEvaluator>(netlist);
}

}  // namespace bump
