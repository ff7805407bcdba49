#pragma once
// Pipeline registers of a scheduled netlist, in bits: those that the register plan (datapath/register_plan.h) has between operators, those
// inside operators of several cycles, and what others need carried past. Dividers, square roots and tables hold what
// datapath/array_registers.h says, a multiplier of several cycles its factors, any other its result, at each clock edge inside. The emitted
// Verilog has exactly these bits; synthesis takes away those that never change. At an initiation interval of i a register between
// operators serves i edges; operators work every cycle. Left out: what the flow of tokens takes, which every unit has alike (the FIFO in
// front, the completion queue behind, credits).

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/netlist.h"
#include "datapath/schedule.h"

namespace bump {

/// A word that only passes the unit, or leaves it as it came, for a reader behind.
struct CarriedWord {
  std::string name;  ///< as later netlists call it; an input of this netlist if it has one of that name
  int width = 0;     ///< bits
};

struct RegisterBits {
  std::int64_t between = 0;  ///< values between operators
  std::int64_t inside = 0;   ///< of operators that take several cycles
  std::int64_t carried = 0;  ///< words for later readers
  std::int64_t waiting = 0;  ///< with shared multipliers: operands in front of their turn, and results until they leave

  std::int64_t total() const { return between + inside + carried + waiting; }
};

/// At the schedule's initiation interval.
RegisterBits pipeline_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried = {});
/// Bits that one execution clocks: every boundary counts.
RegisterBits clocked_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried = {});

}  // namespace bump
