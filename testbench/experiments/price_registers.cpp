#include "testbench/experiments/price_registers.h"

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

class Lifetimes {
 public:
  Lifetimes(const Netlist& netlist, const Schedule& schedule, int interval)
      : nodes_(netlist.nodes()),
        netlist_(netlist),
        schedule_(schedule),
        interval_(interval),
        last_(nodes_.size(), 0),
        fixed_(nodes_.size(), false) {
    BUMP_ASSERT(schedule.start.size() == nodes_.size());
    find_constants();
    find_last_uses();
  }

  RegisterBits count(const std::vector<CarriedWord>& carried) {
    RegisterBits bits;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (fixed_[i]) continue;
      bits.inside += inside(i);
      if (holds_itself(i)) bits.between += held(i);
    }
    // Held longer than this unit needs them, or only for others.
    for (const CarriedWord& word : carried) {
      const auto port = std::find_if(netlist_.inputs().begin(), netlist_.inputs().end(),
                                     [&](const Netlist::Port& input) { return input.name == word.name; });
      std::int64_t already = 0;
      if (port != netlist_.inputs().end()) already = held(static_cast<std::size_t>(port->node));
      bits.carried += std::max<std::int64_t>(0, word.width * registers_over(1, schedule_.latency) - already);
    }
    return bits;
  }

 private:
  int latency(std::size_t i) const { return schedule_.finish[i] - schedule_.start[i]; }

  /// Computed again behind a boundary from the one operand, at no cost: part of the operand's life.
  bool is_view(std::size_t i) const {
    switch (nodes_[i].op) {
      case Op::shift:
      case Op::negate:
      case Op::absolute:
      case Op::half_turn:
      case Op::is_negative:
      case Op::is_beyond_quarter:
        return true;
      case Op::clamp:
        return latency(i) == 0;
      default:
        return false;
    }
  }
  bool holds_itself(std::size_t i) const { return nodes_[i].op != Op::constant && nodes_[i].op != Op::table && !is_view(i); }

  void find_constants() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const std::vector<int>& operands = nodes_[i].operands;
      fixed_[i] =
          nodes_[i].op == Op::constant ||
          (!operands.empty() && std::all_of(operands.begin(), operands.end(), [&](int o) { return fixed_[static_cast<std::size_t>(o)]; }));
    }
  }
  /// The last boundary that a value itself is read behind; views read their operand when they are read.
  void find_last_uses() {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!is_view(i) && nodes_[i].op != Op::column)
        for (const int operand : nodes_[i].operands) use(operand, schedule_.start[i]);
    for (const Netlist::Port& port : netlist_.outputs()) use(port.node, schedule_.latency);
  }
  void use(int node, int cycle) {
    int& last = last_[static_cast<std::size_t>(node)];
    last = std::max(last, cycle);
  }

  /// First boundary that the value crosses as it is.
  int first(std::size_t i) const {
    const std::size_t made_by = nodes_[i].op == Op::column ? static_cast<std::size_t>(nodes_[i].operands[0]) : i;
    return schedule_.finish[i] + (latency(made_by) > 0 ? 0 : 1);
  }
  /// Registers of one bit over boundaries low .. high.
  std::int64_t registers_over(int low, int high) const { return high < low ? 0 : (high - low + interval_) / interval_; }

  /// Bits over the boundaries of the value's life. At each, the value or the parts of it that are read later.
  std::int64_t held(std::size_t i) const {
    std::vector<std::size_t> views = {i};
    int end = last_[i];
    for (std::size_t v = i + 1; v < nodes_.size(); ++v) {
      if (!is_view(v) || std::find(views.begin(), views.end(), static_cast<std::size_t>(nodes_[v].operands[0])) == views.end()) continue;
      views.push_back(v);
      end = std::max(end, last_[v]);
    }
    std::int64_t bits = 0;
    for (int boundary = first(i); boundary <= end; boundary += interval_) {
      int parts = 0;
      for (const std::size_t v : views)
        if (last_[v] >= boundary) parts += nodes_[v].format.width;
      bits += std::min(parts, nodes_[i].format.width);
    }
    return bits;
  }

  /// State of an operator that takes several cycles.
  std::int64_t inside(std::size_t i) const {
    if (latency(i) < 2) return 0;
    const auto width = [&](std::size_t operand) { return nodes_[static_cast<std::size_t>(nodes_[i].operands[operand])].format.width; };
    const Format& format = nodes_[i].format;
    int state = format.width;
    if (nodes_[i].op == Op::mul) state = width(0) + width(1);
    if (nodes_[i].op == Op::div) state = magnitude_bits(format) + 2 * width(1) + (format.is_signed ? 1 : 0);
    if (nodes_[i].op == Op::sqrt) state = 2 * magnitude_bits(format) + 1;
    if (nodes_[i].op == Op::table) {
      state = 0;
      for (const Column& column : netlist_.tables()[static_cast<std::size_t>(nodes_[i].table)]->columns) state += column.format.width;
    }
    return state * registers_over(1, latency(i) - 1);
  }

  const std::vector<Node>& nodes_;
  const Netlist& netlist_;
  const Schedule& schedule_;
  int interval_;
  std::vector<int> last_;
  std::vector<bool> fixed_;
};

}  // namespace

RegisterBits pipeline_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried) {
  return Lifetimes(netlist, schedule, schedule.initiation_interval).count(carried);
}

RegisterBits clocked_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried) {
  return Lifetimes(netlist, schedule, 1).count(carried);
}

}  // namespace bump
