#pragma once
// A memory port behind one stage, clocked: requests spend the tag latency on their way, queue in token order, are granted when the bus is
// free and fewer than the allowed misses are in flight, and fill after the memory's latency. Every delay is a counter that counts down.
// Leaves out banks, rows and refresh. The stage writes `asked` and reads `filled`, both registered running totals of lines.

#include <deque>
#include <systemc>

#include "channels/stepped_control.h"
#include "channels/timing_graph.h"

namespace bump {

class SteppedMemory : public sc_core::sc_module {
 public:
  SteppedMemory(sc_core::sc_module_name name, const MemorySpec& spec, SteppedControl& control);

  sc_core::sc_signal<sc_dt::int64> asked, filled;

  /// No request is anywhere between stage and fill.
  bool idle() const;
  MemoryStatistics statistics() const;
  void trace(sc_core::sc_trace_file* file) const override;

 private:
  void step();
  void take_requests();
  void count_fills();
  void grant();

  const MemorySpec spec_;
  SteppedControl& control_;
  std::int64_t seen_ = 0;     ///< of `asked`
  std::deque<Cycle> tags_;    ///< cycles each request still spends in the tag stage
  sc_dt::int64 queued_ = 0;   ///< requests that wait for a grant
  std::deque<Cycle> misses_;  ///< cycles until each granted line fills; 0: fills in this cycle
  Cycle bus_ = 0;             ///< cycles that the bus is still taken, this one included
  bool bus_busy_ = false;
  std::int64_t requests_ = 0;
  Cycle busy_ = 0;
};

}  // namespace bump
