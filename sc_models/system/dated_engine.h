#pragma once
// The timing plane of the dated engine as a SystemC module: takes the records of retired blocks, dates their tokens with the timeline, and lets
// kernel time follow the dates at block boundaries, so that sc_time_stamp() ends at the cycle count.

#include <systemc>

#include "channels/block_fifo.h"
#include "channels/timeline.h"
#include "system/timing_feed.h"
#include "units/modules.h"

namespace bump {

class DatedEngine : public UnitModule {
 public:
  /// `last_interval` receives the initiation interval of the last token of each stage.
  DatedEngine(const sc_core::sc_module_name& name, Failure& failure, const PipelineTiming& timing, BlockFifo<TimingRecords>& in_records,
              sc_core::sc_time period, std::vector<Cycle>& last_interval);

  /// After the simulation.
  const TimingResult& result() const { return result_; }

 private:
  void work() override;
  void follow(Cycle date);

  const PipelineTiming& timing_;
  BlockFifo<TimingRecords>& in_records_;
  sc_core::sc_time period_;
  std::vector<Cycle>& last_interval_;
  Timeline timeline_;
  TimingResult result_;
};

}  // namespace bump
