#pragma once
// Pipeline registers of a scheduled netlist, from the lifetimes of its values. Between cycles c - 1 and c lies boundary c; a value that is
// computed before a boundary and read behind it is held there, bit for bit. The result of an operator that takes cycles is registered at
// the boundary where it is available; what takes none is computed again from its operand behind the boundary (shifts, signs, flags) or
// held (selects). Of a value that is needed in parts only, the parts are held. Outputs are held up to the latency, where they leave
// together; the registers that deliver the inputs belong to the FIFO in front. An operator of l cycles holds its state at l - 1
// boundaries: a divider its divisor, remainder, quotient and rest of the dividend; a square root radicand, remainder and root; a
// multiplier as many bits as its product. At an initiation interval of i a register serves i boundaries.

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

  std::int64_t total() const { return between + inside + carried; }
};

/// At the schedule's initiation interval.
RegisterBits pipeline_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried = {});
/// Bits that one execution clocks: every boundary counts.
RegisterBits clocked_registers(const Netlist& netlist, const Schedule& schedule, const std::vector<CarriedWord>& carried = {});

}  // namespace bump
