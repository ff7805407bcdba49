#include "testbench/experiments/price_registers.h"

#include <algorithm>
#include <numeric>

#include "datapath/array_registers.h"
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
    const Node& node = nodes_[i];
    if (stages(i) == 0) return 0;
    const auto format = [&](std::size_t operand) { return nodes_[static_cast<std::size_t>(node.operands[operand])].format; };
    switch (node.op) {
      case Op::mul:
        return interval_ > 1 ? 0 : std::int64_t{format(0).width + format(1).width} * stages(i);
      case Op::div:
        return bits_of(divider_edges(format(0), format(1), node.format, stages(i)));
      case Op::sqrt:
        return bits_of(root_edges(format(0), node.format, stages(i)));
      case Op::table:
        return table_edges(*netlist_.tables()[static_cast<std::size_t>(node.table)], stages(i)).bits();
      default:
        return std::int64_t{node.format.width} * stages(i);
    }
  }

  template <class Edge>
  static std::int64_t bits_of(const std::vector<Edge>& edges) {
    return std::accumulate(edges.begin(), edges.end(), std::int64_t{0},
                           [](std::int64_t sum, const Edge& edge) { return sum + edge.bits(); });
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
