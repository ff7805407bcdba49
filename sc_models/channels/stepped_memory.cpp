#include "channels/stepped_memory.h"

#include <algorithm>

namespace bump {

SteppedMemory::SteppedMemory(sc_core::sc_module_name name, const MemorySpec& spec, SteppedControl& control)
    : sc_module(name), asked("asked"), filled("filled"), spec_(spec), control_(control) {
  SC_HAS_PROCESS(SteppedMemory);
  SC_METHOD(step);
  sensitive << control.clock.posedge_event();
  dont_initialize();
}

void SteppedMemory::step() {
  if (control_.asleep()) return;
  take_requests();
  count_fills();
  grant();
}

void SteppedMemory::take_requests() {
  // A request written in cycle s is seen in s+1, when one cycle of the tag latency has passed.
  for (; seen_ < asked.read(); ++seen_) tags_.push_back(spec_.tag_latency - 1);
  while (!tags_.empty() && tags_.front() == 0) {
    tags_.pop_front();
    ++queued_;
  }
  for (Cycle& left : tags_) --left;
}

void SteppedMemory::count_fills() {
  // The slot of a miss is taken up to and including the cycle of its fill.
  while (!misses_.empty() && misses_.front() == 0) misses_.pop_front();
  for (Cycle& left : misses_) --left;
  if (!misses_.empty() && misses_.front() == 0) filled.write(filled.read() + 1);
}

void SteppedMemory::grant() {
  if (bus_ > 0) --bus_;
  if (bus_ == 0 && queued_ > 0 && misses_.size() < static_cast<std::size_t>(spec_.outstanding)) {
    --queued_;
    ++requests_;
    misses_.push_back(spec_.latency);
    bus_ = spec_.cycles_per_line;
  }
  bus_busy_ = bus_ > 0;
  if (bus_busy_) ++busy_;
}

bool SteppedMemory::idle() const {
  return seen_ == asked.read() && tags_.empty() && queued_ == 0 && misses_.empty();
}

MemoryStatistics SteppedMemory::statistics() const {
  // The bus may outlast the last delivery: its last line counts in full.
  return {spec_.name, requests_, busy_ + std::max<Cycle>(0, bus_ - 1)};
}

void SteppedMemory::trace(sc_core::sc_trace_file* file) const {
  const std::string prefix = name();
  sc_core::sc_trace(file, queued_, prefix + ".queued");
  sc_core::sc_trace(file, bus_busy_, prefix + ".bus_busy");
  sc_core::sc_trace(file, asked, prefix + ".asked");
  sc_core::sc_trace(file, filled, prefix + ".filled");
}

}  // namespace bump
