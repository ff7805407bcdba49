// Bit-accurate evaluation. Only what the outputs need is computed, and words live in a slot of their own no longer than something reads
// them, so that a block stays in the nearest cache. A node that somebody asks for is kept from then on; the first time, the block is
// evaluated again from its inputs, which are always kept.

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "datapath/evaluators.h"
#include "datapath/fixed_steps.h"
#include "datapath/invariant.h"
#include "datapath/kept_nodes.h"
#include "datapath/lane_kernels.h"
#include "datapath/rom_cache.h"
#include "datapath/slot_plan.h"

namespace bump {

namespace {

constexpr int lane_group = 16;  ///< lanes are computed in whole groups: the surplus holds valid words that nobody reads
static_assert(block_lanes % lane_group == 0, "whole groups");

class FixedEvaluator : public Evaluator {
 public:
  explicit FixedEvaluator(const Netlist& netlist) : netlist_(netlist), kept_(netlist.nodes().size()) {
    for (const TablePtr& table : netlist.tables()) roms_.push_back(contents_of(table));
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (node(i).op == Op::input || node(i).op == Op::constant) own_[static_cast<int>(i)] = std::make_unique<Own>();
    for (auto& [index, own] : own_) {
      const Node& n = node(static_cast<std::size_t>(index));
      if (n.op != Op::constant) continue;
      const std::int64_t word = quantise(n.value, n.format);
      if (fits_narrow_lane(n.format))
        own->narrow.words.fill(static_cast<std::int32_t>(word));
      else
        own->wide.words.fill(word);
    }
    prepare();
  }

  void evaluate(const double* const* inputs, int lanes, double* const* outputs) override {
    BUMP_ASSERT(lanes >= 0 && lanes <= block_lanes);
    lanes_ = lanes;
    for (std::size_t i = 0; i < netlist_.inputs().size(); ++i) {
      const int port = netlist_.inputs()[i].node;
      const Format& format = node(static_cast<std::size_t>(port)).format;
      const LanePointer words = words_[static_cast<std::size_t>(port)];
      if (words.narrow != nullptr)
        narrow::quantise(inputs[i], format, words.narrow, lanes);
      else
        lanes::quantise(inputs[i], format, words.wide, lanes);
    }
    run();
    for (std::size_t i = 0; i < netlist_.outputs().size(); ++i) {
      const auto port = static_cast<std::size_t>(netlist_.outputs()[i].node);
      if (words_[port].narrow != nullptr)
        narrow::to_double(words_[port].narrow, node(port).format, outputs[i], lanes);
      else
        lanes::to_double(words_[port].wide, node(port).format, outputs[i], lanes);
    }
  }

  double value(int index, int lane) const override {
    const Node& n = node(static_cast<std::size_t>(index));
    return to_double(raw(n.op == Op::table ? n.operands[0] : index, lane), n.format);
  }

  std::int64_t raw(int index, int lane) const override {
    const auto i = static_cast<std::size_t>(index);
    if (!kept_[i]) keep(i);
    const auto j = static_cast<std::size_t>(lane);
    return words_[i].narrow != nullptr ? words_[i].narrow[j] : words_[i].wide[j];
  }

 private:
  /// Words that last: of inputs and constants.
  struct Own {
    NarrowLane narrow;
    WideLane wide;
  };

  const Node& node(std::size_t i) const { return netlist_.nodes()[i]; }
  const Table& table_of(const Node& read) const { return *netlist_.tables()[static_cast<std::size_t>(read.table)]; }

  /// Words that fit a narrow lane are held in one; of a table node, its address.
  bool is_narrow(std::size_t i) const {
    if (node(i).op != Op::table) return fits_narrow_lane(node(i).format);
    const Table& table = table_of(node(i));
    return table.address_bits + table.field_bits() <= 31;
  }

  void run() const {
    const int whole = (lanes_ + lane_group - 1) / lane_group * lane_group;
    for (const FixedStep& step : steps_) step.run(scratch_, whole);
  }

  void keep(std::size_t i) const {
    kept_.keep(i);
    prepare();
    run();
  }

  /// The pass that reads columns of a table, shared by all its reads.
  std::shared_ptr<const NarrowRead> shared_read(int table, std::size_t column, bool pair) const {
    std::shared_ptr<const NarrowRead>& read = reads_[{table, column, pair}];
    const auto i = static_cast<std::size_t>(table);
    if (!read) read = std::make_shared<const NarrowRead>(narrow_read(*netlist_.tables()[i], *roms_[i], column, pair));
    return read;
  }

  /// Which nodes are computed: what outputs and kept nodes reach. A table node stands for its address, which narrow reads have no use for.
  std::vector<bool> reached() const {
    std::vector<bool> reached = kept_.all();
    for (const Netlist::Port& port : netlist_.outputs()) reached[static_cast<std::size_t>(port.node)] = true;
    for (std::size_t i = reached.size(); i-- > 0;) {
      if (!reached[i]) continue;
      if (reads_directly(i))
        reached[static_cast<std::size_t>(node(static_cast<std::size_t>(node(i).operands[0])).operands[0])] = true;
      else
        for (const int operand : node(i).operands) reached[static_cast<std::size_t>(operand)] = true;
    }
    return reached;
  }

  bool reads_directly(std::size_t i) const {
    return node(i).op == Op::column && has_narrow_reads(table_of(node(static_cast<std::size_t>(node(i).operands[0]))));
  }

  void prepare() const {
    steps_.clear();
    std::vector<int> same(kept_.size());  // the node whose words a node shares
    const std::vector<bool> is_reached = reached();
    std::size_t reflections = 0;
    std::vector<bool> done(kept_.size(), false);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      same[i] = static_cast<int>(i);
      if (!is_reached[i] || done[i] || node(i).op == Op::input || node(i).op == Op::constant) continue;
      if (is_same_word(netlist_, static_cast<int>(i))) {
        same[i] = same[static_cast<std::size_t>(node(i).operands[0])];
        continue;
      }
      if (node(i).op == Op::table)
        steps_.push_back(address_step(i, reflections));
      else if (node(i).op == Op::column)
        steps_.push_back(column_step(i, is_reached, done, reflections));
      else
        steps_.push_back(arithmetic_step(netlist_, static_cast<int>(i)));
      for (int& operand : steps_.back().operands)
        if (operand >= 0) operand = same[static_cast<std::size_t>(operand)];
    }
    place(same);
  }

  FixedStep address_step(std::size_t i, std::size_t& reflections) const {
    FixedStep step;
    step.op = Op::table;
    step.node = static_cast<int>(i);
    for (std::size_t j = 0; j < node(i).operands.size(); ++j) step.operands[j] = node(i).operands[j];
    step.table = &table_of(node(i));
    if (reflections_.size() <= reflections) reflections_.push_back(std::make_unique<Reflections>());
    step.reflections = reflections_[reflections++].get();
    return step;
  }

  /// Columns follow their table node directly, so the last reflections are theirs.
  FixedStep column_step(std::size_t i, const std::vector<bool>& is_reached, std::vector<bool>& done, std::size_t reflections) const {
    const int read = node(i).operands[0];
    const Node& read_node = node(static_cast<std::size_t>(read));
    const Table& table = table_of(read_node);
    const auto column = static_cast<std::size_t>(node(i).amount);
    FixedStep step;
    step.op = Op::column;
    step.node = static_cast<int>(i);
    if (reads_directly(i)) {
      step.narrow = true;
      step.operands[0] = read_node.operands[0];
      const bool next_is_column = i + 1 < kept_.size() && node(i + 1).op == Op::column && node(i + 1).operands[0] == read;
      const bool pair = next_is_column && is_reached[i + 1] && packs(table, column);
      step.read = shared_read(read_node.table, column, pair);
      if (pair) {
        step.second_node = static_cast<int>(i + 1);
        done[i + 1] = true;
      }
      return step;
    }
    const Symmetry& symmetry = table.columns[column].symmetry;
    const bool folds = table.folding == Folding::magnitude || table.folding == Folding::quarter;
    step.operands[0] = read;
    step.words = roms_[static_cast<std::size_t>(read_node.table)]->words[column].data();
    step.reflections = reflections_[reflections - 1].get();
    step.odd_zero = symmetry.odd_about_zero && folds ? -1 : 0;
    step.odd_quarter = symmetry.odd_about_quarter && table.folding == Folding::quarter ? -1 : 0;
    return step;
  }

  /// Gives every node's words a place, and steps their pointers.
  void place(const std::vector<int>& same) const {
    SlotPlan plan(kept_.size());
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (kept_[i]) plan.hold(same[i]);
    for (const Netlist::Port& port : netlist_.outputs()) plan.hold(same[static_cast<std::size_t>(port.node)]);
    for (const FixedStep& step : steps_) {
      std::vector<int> made{step.node}, read;
      if (step.second_node >= 0) made.push_back(step.second_node);
      for (const int operand : step.operands)
        if (operand >= 0 && own_.count(operand) == 0) read.push_back(operand);
      plan.step(std::move(made), std::move(read));
    }
    const std::vector<int> slots = plan.assign([&](int i) { return is_narrow(static_cast<std::size_t>(i)) ? 0 : 1; });
    narrow_slots_.resize(static_cast<std::size_t>(plan.slots(0)));
    wide_slots_.resize(static_cast<std::size_t>(plan.slots(1)));
    words_.assign(kept_.size(), {});
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const auto source = static_cast<std::size_t>(same[i]);
      const auto own = own_.find(same[i]);
      if (own == own_.end() && slots[source] < 0) continue;
      if (is_narrow(source))
        words_[i].narrow = (own != own_.end() ? own->second->narrow : narrow_slots_[static_cast<std::size_t>(slots[source])]).words.data();
      else
        words_[i].wide = (own != own_.end() ? own->second->wide : wide_slots_[static_cast<std::size_t>(slots[source])]).words.data();
    }
    for (FixedStep& step : steps_) {
      for (std::size_t j = 0; j < step.in.size(); ++j)
        if (step.operands[j] >= 0) step.in[j] = words_[static_cast<std::size_t>(step.operands[j])];
      step.out = words_[static_cast<std::size_t>(step.node)];
      if (step.second_node >= 0) step.second_out = words_[static_cast<std::size_t>(step.second_node)];
    }
  }

  const Netlist& netlist_;
  std::vector<std::shared_ptr<const TableContents>> roms_;
  std::map<int, std::unique_ptr<Own>> own_;
  int lanes_ = 0;

  // Which nodes are kept is no part of what the evaluator computes: it may change while it is looked at.
  mutable KeptNodes kept_;
  mutable std::map<std::tuple<int, std::size_t, bool>, std::shared_ptr<const NarrowRead>> reads_;
  mutable std::vector<std::unique_ptr<Reflections>> reflections_;
  mutable std::vector<FixedStep> steps_;
  mutable std::vector<NarrowLane> narrow_slots_;
  mutable std::vector<WideLane> wide_slots_;
  mutable std::vector<LanePointer> words_;  ///< by node; null where nothing is computed
  mutable std::array<WideLane, 4> scratch_;
};

}  // namespace

std::unique_ptr<Evaluator> make_fixed_evaluator(const Netlist& netlist) {
  return std::make_unique<FixedEvaluator>(netlist);
}

}  // namespace bump
