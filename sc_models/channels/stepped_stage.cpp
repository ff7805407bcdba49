#include "channels/stepped_stage.h"

#include <algorithm>

namespace bump {

SteppedStage::SteppedStage(sc_core::sc_module_name name, const StageParts& parts)
    : sc_module(name), spec_(parts.spec), inputs_(parts.inputs), memory_(parts.memory), control_(parts.control) {
  for (const StageParts::Output& output : parts.outputs) outputs_.push_back({output, -1});
  statistics_.name = spec_.name;
  SC_HAS_PROCESS(SteppedStage);
  SC_METHOD(step);
  sensitive << control_.clock.posedge_event();
  dont_initialize();
}

void SteppedStage::append(const TokenRecord& record, std::int64_t count) {
  if (count == 0) return;
  const TokenRecord fitted = fitted_record(record, inputs_.size(), outputs_.size(), memory_ != nullptr);
  runs_.append(fitted, count);
  appended_ += count;
  for (std::size_t j = 0; j < outputs_.size(); ++j)
    if ((fitted.give >> j) & 1U) outputs_[j].last_giver = appended_ - 1;
}

bool SteppedStage::wants_records() const {
  if (started_ == appended_) return true;
  const std::int64_t delivered = started_ - static_cast<std::int64_t>(flights_.size());
  return std::any_of(outputs_.begin(), outputs_.end(),
                     [&](const Port& port) { return port.output.needs_end && port.last_giver >= delivered && port.last_giver < started_; });
}

void SteppedStage::step() {
  if (control_.asleep()) return;
  moved_ = false;
  for (Flight& flight : flights_)
    if (flight.left > 0) --flight.left;
  const std::size_t in_flight = flights_.size();  // the credit of a token delivered now is back in the next cycle
  deliver();
  const Issue issued = issue(in_flight);
  state_ = static_cast<int>(issued);
  busy_ = issued == Issue::busy;
  in_flight_ = static_cast<int>(flights_.size());
  ++cycle_;
}

void SteppedStage::deliver() {
  output_blocked_ = false;
  if (flights_.empty()) return;
  const Flight& oldest = flights_.front();
  if (oldest.left > 0 || (oldest.record.misses > 0 && memory_->filled.read() < oldest.fills)) return;
  for (std::size_t j = 0; j < outputs_.size(); ++j)
    if (((oldest.record.give >> j) & 1U) && !outputs_[j].output.fifo->has_room()) output_blocked_ = true;
  if (output_blocked_) {
    ++statistics_.blocked_output;
    return;
  }
  const std::int64_t token = started_ - static_cast<std::int64_t>(flights_.size());
  for (std::size_t j = 0; j < outputs_.size(); ++j)
    if ((oldest.record.give >> j) & 1U) outputs_[j].output.fifo->push(token == outputs_[j].last_giver);
  flights_.pop_front();
  ++statistics_.tokens;
  statistics_.last_delivery = cycle_;
  moved_ = true;
}

SteppedStage::Issue SteppedStage::issue(std::size_t in_flight) {
  if (interval_left_ > 0) {
    --interval_left_;
    ++statistics_.busy;
    return Issue::busy;
  }
  if (runs_.left(next_) == 0) return Issue::idle;
  const TokenRecord record = runs_.record(next_);
  if (!inputs_ready(record)) {
    ++statistics_.starved;
    return Issue::starved;
  }
  if (in_flight == static_cast<std::size_t>(spec_.capacity)) {
    ++statistics_.blocked_room;
    return Issue::blocked;
  }
  start(record);
  ++statistics_.busy;
  return Issue::busy;
}

bool SteppedStage::inputs_ready(const TokenRecord& record) const {
  const bool first_of_batch = started_ % spec_.batch == 0;
  for (std::size_t j = 0; j < inputs_.size(); ++j) {
    if (((record.take >> j) & 1U) == 0) continue;
    const std::int64_t needed = first_of_batch && !inputs_[j]->ends() ? spec_.batch : 1;
    if (inputs_[j]->occupancy() < needed) return false;
  }
  return true;
}

void SteppedStage::start(const TokenRecord& record) {
  for (std::size_t j = 0; j < inputs_.size(); ++j)
    if ((record.release >> j) & 1U) inputs_[j]->pop();
  if (record.misses > 0) {
    asked_ += record.misses;
    memory_->asked.write(asked_);
  }
  flights_.push_back({record, spec_.latency + record.lead, asked_});
  interval_left_ = Cycle{record.interval} - 1;
  ++started_;
  ++next_.used;
  runs_.drop_before(next_);
  moved_ = true;
}

bool SteppedStage::counting() const {
  return interval_left_ > 0 || std::any_of(flights_.begin(), flights_.end(), [](const Flight& flight) { return flight.left > 0; });
}

bool SteppedStage::empty() const {
  return started_ == appended_ && flights_.empty();
}

StageStatistics SteppedStage::statistics() const {
  // The interval of the last token may outlast the last delivery: it counts in full.
  StageStatistics result = statistics_;
  result.busy += interval_left_;
  return result;
}

UntimedState::Stage SteppedStage::untimed() const {
  UntimedState::Stage state;
  state.started = started_;
  state.delivered = statistics_.tokens;
  for (const Flight& flight : flights_) state.runs.push_back({flight.record, 1});
  for (const TokenRun& run : runs_.rest(next_)) state.runs.push_back(run);
  return state;
}

void SteppedStage::trace(sc_core::sc_trace_file* file) const {
  const std::string prefix = name();
  sc_core::sc_trace(file, state_, prefix + ".state");
  sc_core::sc_trace(file, busy_, prefix + ".busy");
  sc_core::sc_trace(file, in_flight_, prefix + ".in_flight");
  sc_core::sc_trace(file, output_blocked_, prefix + ".output_blocked");
}

}  // namespace bump
