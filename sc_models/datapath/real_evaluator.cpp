// Double-precision evaluation: the algorithm itself. Full-turn angles wrap, nothing else is rounded; tables call their functions
// (real_steps.cpp). Values live in slots as long as something reads them, and a node that somebody asks for is kept from then on, as in
// fixed_evaluator.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "datapath/evaluators.h"
#include "datapath/invariant.h"
#include "datapath/kept_nodes.h"
#include "datapath/real_kernels.h"
#include "datapath/real_steps.h"
#include "datapath/slot_plan.h"

namespace bump {

namespace {

struct alignas(64) Lane {
  std::array<double, block_lanes> values{};
};

class RealEvaluator : public Evaluator {
 public:
  explicit RealEvaluator(const Netlist& netlist) : netlist_(netlist), kept_(netlist.nodes().size()) {
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (node(i).op != Op::input && node(i).op != Op::constant) continue;
      own_[static_cast<int>(i)] = std::make_unique<Lane>();
      if (node(i).op == Op::constant) own_[static_cast<int>(i)]->values.fill(wrap_turns(node(i).value, node(i).format));
    }
    prepare();
  }

  void evaluate(const double* const* inputs, int lanes, double* const* outputs) override {
    BUMP_ASSERT(lanes >= 0 && lanes <= block_lanes);
    lanes_ = lanes;
    for (std::size_t i = 0; i < netlist_.inputs().size(); ++i) {
      const auto port = static_cast<std::size_t>(netlist_.inputs()[i].node);
      double* values = own_.at(static_cast<int>(port))->values.data();
      std::copy(inputs[i], inputs[i] + lanes, values);
      if (node(port).format.wraps()) real_lanes::wrap(values, lanes);
    }
    run();
    for (std::size_t i = 0; i < netlist_.outputs().size(); ++i) {
      const double* values = values_[static_cast<std::size_t>(netlist_.outputs()[i].node)];
      std::copy(values, values + lanes, outputs[i]);
    }
  }

  double value(int index, int lane) const override {
    const auto i = static_cast<std::size_t>(index);
    if (!kept_[i]) keep(i);
    return values_[i][lane];
  }

  std::int64_t raw(int, int) const override {
    const bool evaluates_words = false;
    BUMP_ASSERT(evaluates_words);
    return 0;
  }

 private:
  const Node& node(std::size_t i) const { return netlist_.nodes()[i]; }

  void keep(std::size_t i) const {
    kept_.keep(i);
    prepare();
    run();
  }

  /// Wiring that changes nothing. Angles of one turn have been wrapped where they were made; wrapping them again changes no bit.
  bool is_same_value(const Node& n) const {
    const auto was_wrapped = [&] { return node(static_cast<std::size_t>(n.operands[0])).format.wraps(); };
    if (n.op == Op::table) return !wraps(n) || was_wrapped();
    return n.op == Op::shift && n.amount == 0 && (!wraps(n) || was_wrapped());
  }

  /// A table node stands for its index, which wraps by the table's format.
  bool wraps(const Node& n) const {
    if (n.op == Op::table) return netlist_.tables()[static_cast<std::size_t>(n.table)]->index.wraps() || n.format.wraps();
    return n.format.wraps();
  }

  void prepare() const {
    steps_.clear();
    std::vector<bool> reached = kept_.all();
    for (const Netlist::Port& port : netlist_.outputs()) reached[static_cast<std::size_t>(port.node)] = true;
    for (std::size_t i = reached.size(); i-- > 0;) {
      if (!reached[i]) continue;
      for (const int operand : node(i).operands) reached[static_cast<std::size_t>(operand)] = true;
    }
    std::vector<int> same(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Node& n = node(i);
      same[i] = static_cast<int>(i);
      if (!reached[i] || own_.count(static_cast<int>(i)) != 0) continue;
      if (is_same_value(n)) {
        same[i] = same[static_cast<std::size_t>(n.operands[0])];
        continue;
      }
      if (n.op == Op::column && read_already(n)) continue;
      steps_.push_back(step_of(static_cast<int>(i), same));
    }
    place(same);
  }

  const Table& table_of(const Node& column) const {
    return *netlist_.tables()[static_cast<std::size_t>(node(static_cast<std::size_t>(column.operands[0])).table)];
  }

  /// A block function has computed all columns when the first of them was needed.
  bool read_already(const Node& column) const {
    if (!table_of(column).block) return false;
    return std::any_of(steps_.begin(), steps_.end(),
                       [&](const RealStep& s) { return s.table != nullptr && s.node->operands[0] == column.operands[0]; });
  }

  bool holds_turn(int operand) const { return node(static_cast<std::size_t>(operand)).format.wraps(); }
  bool combines_turns(const Node& n) const {
    const bool combines = n.op == Op::add || n.op == Op::join || n.op == Op::sub || n.op == Op::negate || n.op == Op::half_turn;
    return combines && std::all_of(n.operands.begin(), n.operands.end(), [&](int operand) { return holds_turn(operand); });
  }
  bool selects_turn(const Node& n) const { return n.op == Op::select && holds_turn(n.operands[1]) && holds_turn(n.operands[2]); }

  RealStep step_of(int index, const std::vector<int>& same) const {
    const Node& n = node(static_cast<std::size_t>(index));
    RealStep step;
    step.node = &n;
    step.made = {index};
    step.of_turns = wraps(n) && combines_turns(n);
    step.wraps = {wraps(n) && !step.of_turns && !selects_turn(n)};
    step.factor = n.op == Op::shift ? std::ldexp(1.0, n.amount) : 1.0;
    for (std::size_t j = 0; j < n.operands.size(); ++j) step.operands[j] = same[static_cast<std::size_t>(n.operands[j])];
    if (n.op != Op::column) return step;
    const Table& table = table_of(n);
    step.table = &table;
    const Node& read = node(static_cast<std::size_t>(n.operands[0]));
    for (std::size_t j = 1; j < read.operands.size(); ++j) {
      const auto operand = static_cast<std::size_t>(read.operands[j]);
      step.operands[j] = same[operand];
      step.wraps_index[j] = table.fields[j - 1].index.wraps() && !node(operand).format.wraps();
    }
    if (table.block) {
      // A table's columns follow it in the list.
      step.made.resize(table.columns.size());
      std::iota(step.made.begin(), step.made.end(), n.operands[0] + 1);
      step.wraps.clear();
      for (const Column& column : table.columns) step.wraps.push_back(column.format.wraps());
    }
    return step;
  }

  void place(const std::vector<int>& same) const {
    SlotPlan plan(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) plan.hold(same[i]);
    for (const Netlist::Port& port : netlist_.outputs()) plan.hold(same[static_cast<std::size_t>(port.node)]);
    for (const RealStep& step : steps_) {
      std::vector<int> read;
      for (const int operand : step.operands)
        if (operand >= 0 && own_.count(operand) == 0) read.push_back(operand);
      plan.step(step.made, std::move(read));
    }
    const std::vector<int> slots = plan.assign([](int) { return 0; });
    slots_.resize(static_cast<std::size_t>(plan.slots(0)));
    values_.assign(kept_.size(), nullptr);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const int slot = slots[static_cast<std::size_t>(same[i])];
      const auto own = own_.find(same[i]);
      if (own != own_.end())
        values_[i] = own->second->values.data();
      else if (slot >= 0)
        values_[i] = slots_[static_cast<std::size_t>(slot)].values.data();
    }
    for (RealStep& step : steps_) {
      for (std::size_t j = 0; j < step.in.size(); ++j)
        if (step.operands[j] >= 0) step.in[j] = values_[static_cast<std::size_t>(step.operands[j])];
      for (const int made : step.made) step.out.push_back(values_[static_cast<std::size_t>(made)]);
    }
  }

  void run() const {
    for (const RealStep& step : steps_) run_real_step(step, lanes_);
  }

  const Netlist& netlist_;
  std::map<int, std::unique_ptr<Lane>> own_;  ///< values that last: of inputs and constants
  int lanes_ = 0;

  // Which nodes are kept is no part of what the evaluator computes: it may change while it is looked at.
  mutable KeptNodes kept_;
  mutable std::vector<RealStep> steps_;
  mutable std::vector<Lane> slots_;
  mutable std::vector<double*> values_;  ///< by node; null where nothing is computed. Table nodes hold the index
};

}  // namespace

std::unique_ptr<Evaluator> make_real_evaluator(const Netlist& netlist) {
  return std::make_unique<RealEvaluator>(netlist);
}

}  // namespace bump
