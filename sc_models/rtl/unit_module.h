#pragma once
// A unit of the pipeline as Verilog: its datapath with valid and ready on both sides, exactly the stage of the timing model
// (timing_graph.h): a pipeline that never stalls, a completion queue of CAPACITY words behind it, and as many credits in front. Token k
// starts, is finished and is delivered in cycles
//   s(k) = max(s(k-1) + II, arrival(k), w(k-CAPACITY) + 1)
//   d(k) = max(s(k) + L, w(k-1) + 1)
//   w(k) = first cycle from d(k) on with out_ready
// where a token starts at the clock edge that ends a cycle with in_valid and in_ready, and is delivered at that of one with out_valid and
// out_ready. in_ready, out_valid and the words come from registers alone: no path leads from one side's handshake to the other's.
// With shared multipliers (II > 1) the datapath reads operands every II cycles; what comes in between waits in an entry register. L counts
// the longest such wait, so that it is the same for every token. Where a fixed unit shares the stage behind this one, its cycles are the
// parameter TAIL: results are then released, and d(k) comes, so much later.

#include <string>
#include <vector>

#include "rtl/datapath_module.h"
#include "rtl/verilog.h"

namespace bump {

/// What the test bench, the harness and the manifest must know of an emitted unit.
struct RtlUnit {
  std::string unit;      ///< as users type it, e.g. "environment"
  VerilogModule module;  ///< "<scheme>_<unit>", parameters CAPACITY and TAIL
  std::vector<DatapathModule::Port> inputs, outputs;
  int latency = 1;              ///< L, cycles, >= 1
  int initiation_interval = 1;  ///< II, cycles
  int capacity = 2;             ///< value of CAPACITY when it is not given: tokens in flight
};

/// Registers of the wrapper, in bits, by purpose; the datapath's own come on top.
struct WrapperRegisters {
  int control = 0;  ///< credits, interval, phase, starts, indices of the queue
  int entry = 0;    ///< operands that wait for their turn
  int result = 0;   ///< of a datapath that takes no cycle
  int queue = 0;    ///< words of finished tokens
};

/// Bits of all words of the ports together.
int word_bits(const std::vector<DatapathModule::Port>& ports);

/// `capacity` 0 means L + 1, enough for a token every II cycles. The datapath has inputs and outputs; one without registers has no port
/// clk.
RtlUnit unit_module(const std::string& scheme, const std::string& unit, const DatapathModule& datapath, int capacity = 0);

WrapperRegisters wrapper_registers(const RtlUnit& unit, const DatapathModule& datapath);

}  // namespace bump
