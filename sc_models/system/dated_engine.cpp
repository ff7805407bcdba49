#include "system/dated_engine.h"

namespace bump {

DatedEngine::DatedEngine(const sc_core::sc_module_name& name, Failure& failure, const PipelineTiming& timing,
                         BlockFifo<TimingRecords>& in_records, sc_core::sc_time period, std::vector<Cycle>& last_interval)
    : UnitModule(name, failure), timing_(timing), in_records_(in_records), period_(period), last_interval_(last_interval), timeline_(timing.graph) {}

void DatedEngine::follow(Cycle date) {
  const sc_core::sc_time then = period_ * static_cast<double>(date);
  if (then > sc_core::sc_time_stamp()) wait(then - sc_core::sc_time_stamp());
}

void DatedEngine::work() {
  while (const auto records = in_records_.read()) {
    host_clock_.start();
    feed(timeline_, *records, timing_, last_interval_);
    timeline_.advance();
    host_clock_.stop();
    follow(timeline_.latest());
  }
  result_ = timeline_.finish();
  follow(result_.cycles);
  sc_core::sc_stop();
}

}  // namespace bump
