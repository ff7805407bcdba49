// Bit-accurate evaluation. Every node owns an array of words; the constants of an operator (shifts, masks, bounds) are worked out once.

#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/arithmetic.h"
#include "datapath/evaluators.h"
#include "datapath/invariant.h"
#include "datapath/lane_kernels.h"
#include "datapath/lane_math.h"
#include "datapath/rom_cache.h"

namespace bump {

namespace {

using Lane = std::array<std::int64_t, block_lanes>;

struct Step {
  Op op = Op::input;
  const std::int64_t* a = nullptr;  ///< operands
  const std::int64_t* b = nullptr;
  const std::int64_t* c = nullptr;
  std::int64_t* out = nullptr;
  Format format{};
  RoundingRule rule{}, other_rule{};
  int left_a = 0, left_b = 0, right = 0;
  int width = 0;  ///< of the first operand
  DividerShape divider{};
  RootShape root{};
  bool narrow = false;
  std::int64_t low = 0, high = 0;
  const Table* table = nullptr;
  const std::int64_t* words = nullptr;  ///< column: ROM words
  std::int64_t* negative = nullptr;     ///< table and column: where the index was reflected
  std::int64_t* beyond = nullptr;
  std::int64_t odd_zero = 0, odd_quarter = 0;
};

/// A clamp's bound as a word of the result: to nearest, and saturated even for an angle that wraps.
std::int64_t bound_word(double bound, Format format) {
  format.is_angle = false;
  return quantise(bound, format);
}

class FixedEvaluator : public Evaluator {
 public:
  explicit FixedEvaluator(const Netlist& netlist) : netlist_(netlist), lanes_(netlist.nodes().size()) {
    reads_.reserve(netlist.nodes().size());  // steps point into it
    for (const TablePtr& table : netlist.tables()) roms_.push_back(contents_of(table));
    for (std::size_t i = 0; i < netlist.nodes().size(); ++i) prepare(i);
  }

  void evaluate(const double* const* inputs, int lanes, double* const* outputs) override {
    BUMP_ASSERT(lanes >= 0 && lanes <= block_lanes);
    for (std::size_t i = 0; i < netlist_.inputs().size(); ++i) {
      const auto node = static_cast<std::size_t>(netlist_.inputs()[i].node);
      lanes::quantise(inputs[i], netlist_.nodes()[node].format, lanes_[node].data(), lanes);
    }
    for (const Step& step : steps_) run(step, lanes);
    for (std::size_t i = 0; i < netlist_.outputs().size(); ++i) {
      const auto node = static_cast<std::size_t>(netlist_.outputs()[i].node);
      lanes::to_double(lanes_[node].data(), netlist_.nodes()[node].format, outputs[i], lanes);
    }
  }

  double value(int node, int lane) const override {
    const Node& n = netlist_.nodes()[static_cast<std::size_t>(node)];
    const int source = n.op == Op::table ? n.operands[0] : node;
    return to_double(raw(source, lane), n.format);
  }

  std::int64_t raw(int node, int lane) const override { return lanes_[static_cast<std::size_t>(node)][static_cast<std::size_t>(lane)]; }

 private:
  struct Reflections {
    Lane negative{}, beyond{};
  };

  void prepare(std::size_t i) {
    const Node& node = netlist_.nodes()[i];
    if (node.op == Op::constant) lanes_[i].fill(quantise(node.value, node.format));
    if (node.op == Op::input || node.op == Op::constant) return;
    Step step;
    step.op = node.op;
    step.out = lanes_[i].data();
    step.format = node.format;
    const std::int64_t** operand_words[] = {&step.a, &step.b, &step.c};
    for (std::size_t j = 0; j < node.operands.size(); ++j) *operand_words[j] = lanes_[static_cast<std::size_t>(node.operands[j])].data();
    const auto operand = [&](std::size_t j) -> const Format& {
      return netlist_.nodes()[static_cast<std::size_t>(node.operands[j])].format;
    };
    const Format& to = node.format;
    const int fraction = operand(0).fraction;
    step.width = operand(0).width;
    step.rule = rounding_rule(fraction, to);
    switch (node.op) {
      case Op::add:
      case Op::sub:
      case Op::join: {
        const int common = std::max(fraction, operand(1).fraction);
        step.left_a = common - fraction;
        step.left_b = common - operand(1).fraction;
        step.rule = rounding_rule(common, to);
        break;
      }
      case Op::mul:
        step.rule = rounding_rule(fraction + operand(1).fraction, to);
        break;
      case Op::div:
        step.divider = divider_shape(operand(0), operand(1), to);
        step.narrow = step.divider.rows <= narrow_bits && operand(0).width <= narrow_bits && operand(1).width <= narrow_bits;
        break;
      case Op::sqrt:
        step.root = root_shape(operand(0), to);
        step.narrow = std::max(step.width, step.width + step.root.shift) <= narrow_bits && step.root.magnitude <= narrow_bits;
        break;
      case Op::shift:
        step.rule = rounding_rule(fraction - node.amount, to);
        break;
      case Op::clamp:
        step.left_a = std::max(0, to.fraction - fraction);
        step.right = std::clamp(fraction - to.fraction, 0, 62);
        step.low = bound_word(node.low, to);
        step.high = bound_word(node.high, to);
        break;
      case Op::select:
        step.rule = rounding_rule(operand(1).fraction, to);
        step.other_rule = rounding_rule(operand(2).fraction, to);
        break;
      case Op::table:
        prepare_table(node, step);
        break;
      case Op::column:
        prepare_column(node, step);
        break;
      default:
        break;
    }
    steps_.push_back(step);
  }

  void prepare_table(const Node& node, Step& step) {
    step.table = netlist_.tables()[static_cast<std::size_t>(node.table)].get();
    reads_.emplace_back();
    step.negative = reads_.back().negative.data();
    step.beyond = reads_.back().beyond.data();
  }

  /// Columns follow their table node directly, so the last reflections are theirs.
  void prepare_column(const Node& node, Step& step) {
    const Node& read = netlist_.nodes()[static_cast<std::size_t>(node.operands[0])];
    const auto table = static_cast<std::size_t>(read.table);
    const auto column = static_cast<std::size_t>(node.amount);
    const Folding folding = netlist_.tables()[table]->folding;
    const Symmetry& symmetry = netlist_.tables()[table]->columns[column].symmetry;
    step.words = roms_[table]->words[column].data();
    step.negative = reads_.back().negative.data();
    step.beyond = reads_.back().beyond.data();
    step.odd_zero = symmetry.odd_about_zero && (folding == Folding::magnitude || folding == Folding::quarter) ? -1 : 0;
    step.odd_quarter = symmetry.odd_about_quarter && folding == Folding::quarter ? -1 : 0;
  }

  static void run(const Step& s, int lanes) {
    switch (s.op) {
      case Op::add:
      case Op::join:
        return lanes::add(s.a, s.left_a, s.b, s.left_b, s.rule, s.out, lanes);
      case Op::sub:
        return lanes::subtract(s.a, s.left_a, s.b, s.left_b, s.rule, s.out, lanes);
      case Op::mul:
        return lanes::multiply(s.a, s.b, s.rule, s.out, lanes);
      case Op::div:
        return lanes::divide(s.a, s.b, s.divider, s.narrow, s.out, lanes);
      case Op::sqrt:
        return lanes::root(s.a, s.root, s.narrow, s.out, lanes);
      case Op::table:
        return lanes::addresses(*s.table, {s.a, s.b, s.c}, s.out, s.negative, s.beyond, lanes);
      case Op::column:
        return lanes::read(s.words, s.a, s.negative, s.odd_zero, s.beyond, s.odd_quarter, s.out, lanes);
      case Op::shift:
        return lanes::move(s.a, s.rule, s.out, lanes);
      case Op::negate:
        return lanes::negate(s.a, s.rule, s.out, lanes);
      case Op::absolute:
        return lanes::absolute(s.a, s.rule, s.out, lanes);
      case Op::half_turn:
        return lanes::half_turn(s.a, s.width, s.out, lanes);
      case Op::clamp:
        return lanes::clamp(s.a, s.left_a, s.right, s.low, s.high, s.out, lanes);
      case Op::select:
        return lanes::select(s.a, s.b, s.rule, s.c, s.other_rule, s.out, lanes);
      case Op::is_negative:
        return lanes::is_negative(s.a, s.out, lanes);
      case Op::is_beyond_quarter:
        return lanes::is_beyond_quarter(s.a, s.width, s.out, lanes);
      case Op::input:
      case Op::constant:
        return;
    }
  }

  const Netlist& netlist_;
  std::vector<Lane> lanes_;  ///< words per node; table nodes hold addresses
  std::vector<Reflections> reads_;
  std::vector<std::shared_ptr<const TableContents>> roms_;
  std::vector<Step> steps_;
};

}  // namespace

std::unique_ptr<Evaluator> make_fixed_evaluator(const Netlist& netlist) {
  return std::make_unique<FixedEvaluator>(netlist);
}

}  // namespace bump
