#pragma once
// Turns a netlist into a pipeline: the cycle in which every operator starts, the latency and the initiation interval. Without a limit on
// multipliers every operator is its own hardware and a result leaves every cycle. With a limit of m, products share m multipliers: the
// initiation interval is ceil(multipliers / m) and operators are placed, in order of their depth, in the earliest cycle in which a
// multiplier is free modulo that interval. Shared multipliers come round once an interval: what arrives in between waits for its turn in a
// register at the entry. So that a unit's latency does not depend on when its operands come, it is counted with the longest such wait.

#include <vector>

#include "datapath/netlist.h"

namespace bump {

/// Cycles of each operator, >= 0. Wiring and sign logic take none: they are absorbed by the operator they feed.
struct OperatorLatencies {
  int adder = 1;
  int multiplier = 1;
  int table = 1;
  int clamp = 1;
  int shifter = 1;                     ///< barrel shifter
  int divider_bits_per_cycle = 1;      ///< quotient magnitude bits resolved each cycle, >= 1
  int square_root_bits_per_cycle = 1;  ///< root bits resolved each cycle, >= 1
};

struct Schedule {
  std::vector<int> start;   ///< per node: cycle in which it takes its operands
  std::vector<int> finish;  ///< per node: cycle in which its result is available
  int latency = 0;          ///< cycles from the inputs' turn to the last output, >= 0
  int initiation_interval = 1;
  int multipliers_built = 0;  ///< after sharing

  /// Cycles from the arrival of the operands to the result: with shared multipliers the wait for their turn is in it.
  int unit_latency() const { return latency + initiation_interval - 1; }
};

/// Cycles of one node under the given latencies.
int latency_of(const Node& node, const OperatorLatencies& latencies);

/// multiplier_limit 0 means unlimited. Throws Error(input) on negative numbers.
Schedule schedule(const Netlist& netlist, const OperatorLatencies& latencies, int multiplier_limit = 0);

}  // namespace bump
