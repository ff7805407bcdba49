#include "testbench/experiments/price_registers.h"

#include <algorithm>

#include "datapath/arithmetic.h"
#include "datapath/register_plan.h"
#include "rtl/shared_multipliers.h"

namespace bump {

namespace {

class Registers {
 public:
  Registers(const Netlist& netlist, const Schedule& schedule, int interval)
      : nodes_(netlist.nodes()), netlist_(netlist), schedule_(schedule), interval_(interval), plan_(netlist, schedule, interval) {}

  RegisterBits count(const std::vector<CarriedWord>& carried) const {
    RegisterBits bits;
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
      bits.between += plan_.bits_of(i);
      if (!plan_.is_fixed(i)) bits.inside += inside(static_cast<std::size_t>(i));
    }
    if (interval_ > 1)
      for (const SharedMultiplier& multiplier : shared_multipliers(netlist_, schedule_))
        bits.inside +=
            std::int64_t{multiplier.width_a + multiplier.width_b} * stages(static_cast<std::size_t>(multiplier.products.front()));
    // Held longer than this unit needs them, or only for others.
    for (const CarriedWord& word : carried) {
      const auto port = std::find_if(netlist_.inputs().begin(), netlist_.inputs().end(),
                                     [&](const Netlist::Port& input) { return input.name == word.name; });
      const std::int64_t already = port != netlist_.inputs().end() ? plan_.bits_of(port->node) : 0;
      bits.carried += std::max<std::int64_t>(0, word.width * registers_over(1, schedule_.unit_latency()) - already);
    }
    if (schedule_.initiation_interval > 1)
      for (const auto* ports : {&netlist_.inputs(), &netlist_.outputs()})
        for (const Netlist::Port& port : *ports) bits.waiting += nodes_[static_cast<std::size_t>(port.node)].format.width;
    return bits;
  }

 private:
  /// Registers of one bit over boundaries low .. high.
  std::int64_t registers_over(int low, int high) const { return high < low ? 0 : (high - low + interval_) / interval_; }

  /// Clock edges inside an operator.
  int stages(std::size_t i) const { return std::max(0, schedule_.finish[i] - schedule_.start[i] - 1); }

  /// State of an operator that takes several cycles: it takes new operands every cycle, whatever the interval. Shared multipliers apart.
  std::int64_t inside(std::size_t i) const {
    if (stages(i) == 0 || (nodes_[i].op == Op::mul && interval_ > 1)) return 0;
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
    return std::int64_t{state} * stages(i);
  }

  const std::vector<Node>& nodes_;
  const Netlist& netlist_;
  const Schedule& schedule_;
  int interval_;
  RegisterPlan plan_;
};

}  // namespace

RegisterBits pipeline_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried) {
  return Registers(netlist, schedule, schedule.initiation_interval).count(carried);
}

RegisterBits clocked_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried) {
  return Registers(netlist, schedule, 1).count(carried);
}

}  // namespace bump
