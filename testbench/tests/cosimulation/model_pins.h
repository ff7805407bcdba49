#pragma once
// A unit behind its pins as emitted Verilog would be, but written here from the recurrences of its stage, with faults to choose from. For
// tests only.

#include <deque>
#include <memory>
#include <vector>

#include "datapath/evaluate.h"
#include "testbench/cosimulation/rtl_pins.h"

namespace bump_test {

enum class Fault {
  none,
  wrong_bit,  ///< the lowest bit of the 100th token's first result
  late,       ///< every result a cycle late
  early,      ///< in_ready without a pause and without credits
  stuck       ///< takes 100 tokens and no more
};

class ModelPins : public bump::RtlPins {
 public:
  struct Timing {
    std::int64_t latency = 1, interval = 1, capacity = 2;
  };
  ModelPins(const bump::Netlist& netlist, const Timing& timing, Fault fault);

  std::vector<Port> operands() const override { return ports(netlist_.inputs()); }
  std::vector<Port> results() const override { return ports(netlist_.outputs()); }
  void drive_clock(bool level) override;
  void drive_reset(bool level) override { reset_ = level; }
  void drive_in_valid(bool level) override { in_valid_ = level; }
  void drive_operands(const std::uint64_t* words) override { operands_.assign(words, words + netlist_.inputs().size()); }
  void drive_out_ready(bool level) override { out_ready_ = level; }
  bool in_ready() const override;
  bool out_valid() const override { return !flights_.empty() && cycle_ >= flights_.front().done; }
  void read_results(std::uint64_t* words) const override;

 private:
  struct Flight {
    std::int64_t done;
    std::vector<std::uint64_t> results;
  };
  const bump::Format& format(const bump::Netlist::Port& port) const { return netlist_.nodes()[static_cast<std::size_t>(port.node)].format; }
  std::vector<Port> ports(const std::vector<bump::Netlist::Port>& of) const;
  std::vector<std::uint64_t> evaluate();

  const bump::Netlist netlist_;
  const Timing timing_;
  const Fault fault_;
  std::unique_ptr<bump::Evaluator> evaluator_;
  bool clock_ = false, reset_ = false, in_valid_ = false, out_ready_ = false;
  std::vector<std::uint64_t> operands_;
  std::deque<Flight> flights_;
  std::int64_t cycle_ = 0, free_ = 0, taken_ = 0;
};

}  // namespace bump_test
