#include "testbench/cosimulation/rtl_stage.h"

#include <fmt/core.h>

#include "datapath/invariant.h"

namespace bump {

namespace {

/// More than any wait for a turn; a unit that stands still for so long has lost a token.
constexpr Cycle longest_overdue = 1000;

const StageParts& one_in_one_out(const StageParts& parts) {
  BUMP_ASSERT(parts.inputs.size() == 1 && parts.outputs.size() == 1 && parts.memory == nullptr);
  BUMP_ASSERT(parts.spec.batch == 1 && !parts.outputs.front().needs_end);
  return parts;
}

}  // namespace

RtlStage::RtlStage(sc_core::sc_module_name name, const StageParts& parts, const std::function<std::unique_ptr<RtlPins>()>& make_pins,
                   TokenWords& words)
    : sc_module(name),
      spec_(one_in_one_out(parts).spec),
      input_(*parts.inputs.front()),
      output_(*parts.outputs.front().fifo),
      control_(parts.control),
      pins_(make_pins()),
      words_(words),
      results_(pins_->results().size()) {
  statistics_.name = spec_.name;
  SC_HAS_PROCESS(RtlStage);
  SC_THREAD(reset);
  SC_METHOD(edge);
  sensitive << control_.clock.posedge_event() << control_.clock.negedge_event();
  dont_initialize();
}

void RtlStage::reset() {
  pins_->drive_in_valid(false);
  pins_->drive_out_ready(false);
  for (const bool level : {true, false}) {
    pins_->drive_reset(level);
    for (int i = 0; i < 2; ++i) {
      for (const bool clock : {false, true}) {
        pins_->drive_clock(clock);
        wait(sc_core::SC_ZERO_TIME);
        wait(sc_core::SC_ZERO_TIME);
      }
    }
  }
  fall();
}

void RtlStage::edge() {
  if (control_.asleep()) return;
  control_.clock.posedge() ? rise() : fall();
}

void RtlStage::fall() {
  pins_->drive_clock(false);
  offered_ = input_.occupancy() > 0 && runs_.left(next_) > 0;
  pins_->drive_in_valid(offered_);
  if (offered_) pins_->drive_operands(words_.operands());
  pins_->drive_out_ready(output_.has_room());
}

void RtlStage::rise() {
  moved_ = false;
  const bool ready = pins_->in_ready(), valid = pins_->out_valid();
  compare(ready, valid);
  deliver(valid);
  issue(ready);
  pins_->drive_clock(true);
  in_ready_ = ready;
  out_valid_ = valid;
  in_flight_ = static_cast<int>(flights_.size());
  ++cycle_;
}

void RtlStage::compare(bool ready, bool valid) {
  const bool due_ready = interval_left_ == 0 && static_cast<std::int64_t>(flights_.size()) < spec_.capacity;
  const bool due_valid = !flights_.empty() && cycle_ >= flights_.front().start + spec_.latency;
  const bool waits = (offered_ && due_ready && !ready) || (due_valid && !valid);
  overdue_ = waits ? overdue_ + 1 : 0;
  if (ready == due_ready && valid == due_valid) return;
  if (handshake_.wrong_cycles++ > 0) return;
  handshake_.first = fmt::format("in cycle {} in_ready is {} instead of {}, out_valid is {} instead of {}", cycle_, int{ready},
                                 int{due_ready}, int{valid}, int{due_valid});
}

void RtlStage::deliver(bool valid) {
  if (!valid || flights_.empty()) return;  // a token that was never taken has been noted as a wrong cycle
  if (!output_.has_room()) {
    ++statistics_.blocked_output;
    return;
  }
  pins_->read_results(results_.data());
  words_.delivered(results_.data());
  output_.push(false);
  flights_.pop_front();
  ++statistics_.tokens;
  statistics_.last_delivery = cycle_;
  moved_ = true;
}

void RtlStage::issue(bool ready) {
  if (offered_ && ready) {
    const TokenRecord record = runs_.record(next_);
    flights_.push_back({record, cycle_});
    interval_left_ = Cycle{record.interval} - 1;
    ++started_;
    ++next_.used;
    runs_.drop_before(next_);
    input_.pop();
    words_.started();
    ++statistics_.busy;
    moved_ = true;
  } else if (interval_left_ > 0) {
    --interval_left_;
    ++statistics_.busy;
  } else if (runs_.left(next_) == 0) {
    return;
  } else if (!offered_) {
    ++statistics_.starved;
  } else {
    ++statistics_.blocked_room;
  }
}

void RtlStage::append(const TokenRecord& record, std::int64_t count) {
  const TokenRecord fitted = fitted_record(record, 1, 1, false);
  BUMP_ASSERT(fitted.take == 1 && fitted.release == 1 && fitted.give == 1 && fitted.lead == 0);
  runs_.append(fitted, count);
  appended_ += count;
}

void RtlStage::check() const {
  if (overdue_ <= longest_overdue) return;
  throw Error(ErrorKind::self_check,
              {fmt::format("the Verilog of the {} unit stands still after {} tokens", spec_.name, started_), {}, handshake_.first, ""});
}

bool RtlStage::counting() const {
  return overdue_ > 0 || interval_left_ > 0 || (!flights_.empty() && cycle_ < flights_.back().start + spec_.latency);
}

StageStatistics RtlStage::statistics() const {
  // The interval of the last token may outlast the last delivery: it counts in full.
  StageStatistics result = statistics_;
  result.busy += interval_left_;
  return result;
}

HandshakeReport RtlStage::handshake() const {
  HandshakeReport result = handshake_;
  result.tokens = statistics_.tokens;
  return result;
}

UntimedState::Stage RtlStage::untimed() const {
  UntimedState::Stage state;
  state.started = started_;
  state.delivered = statistics_.tokens;
  for (const Flight& flight : flights_) state.runs.push_back({flight.record, 1});
  for (const TokenRun& run : runs_.rest(next_)) state.runs.push_back(run);
  return state;
}

void RtlStage::trace(sc_core::sc_trace_file* file) const {
  const std::string prefix = name();
  sc_core::sc_trace(file, offered_, prefix + ".in_valid");
  sc_core::sc_trace(file, in_ready_, prefix + ".in_ready");
  sc_core::sc_trace(file, out_valid_, prefix + ".out_valid");
  sc_core::sc_trace(file, in_flight_, prefix + ".in_flight");
}

}  // namespace bump
