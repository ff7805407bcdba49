#include "channels/dated_stage.h"

#include <algorithm>
#include <array>

namespace bump {

namespace {

bool has(std::uint8_t mask, std::size_t port) {
  return ((mask >> port) & 1U) != 0;
}

/// The FIFOs of a mask.
struct Ports {
  Ports(const std::vector<DatedFifo*>& all, std::uint8_t mask) {
    for (std::size_t j = 0; j < all.size(); ++j)
      if (has(mask, j)) fifos[count++] = all[j];
  }
  DatedFifo** begin() { return fifos.data(); }
  DatedFifo** end() { return fifos.data() + count; }

  std::array<DatedFifo*, 8> fifos{};
  std::size_t count = 0;
};

/// A FIFO's state for an inner loop, so that it stays in registers: for the compiler, dates and counts could alias.
struct FifoView {
  Cycle* writes = nullptr;
  Cycle* removals = nullptr;
  std::uint64_t mask = 0, written = 0, removed = 0, depth = 0, largest = 0;
  Cycle last_write = 0, last_removal = 0;
};

FifoView view_of(DatedFifo& fifo) {
  FifoView view;
  view.writes = fifo.writes.data();
  view.removals = fifo.removals.data();
  view.mask = fifo.writes.mask();
  view.written = static_cast<std::uint64_t>(fifo.written);
  view.removed = static_cast<std::uint64_t>(fifo.removed);
  view.depth = static_cast<std::uint64_t>(fifo.depth);
  view.largest = static_cast<std::uint64_t>(fifo.largest());
  view.last_write = fifo.last_write;
  view.last_removal = fifo.last_removal;
  return view;
}

}  // namespace

DatedStage::DatedStage(const StageSpec& spec, std::vector<DatedFifo*> inputs, std::vector<DatedFifo*> outputs, DatedMemory* memory)
    : spec_(spec),
      inputs_(std::move(inputs)),
      outputs_(std::move(outputs)),
      memory_(memory),
      simple_(spec.batch == 1 && inputs_.size() <= 1 && outputs_.size() <= 1),
      ready_(spec.capacity),
      deliveries_(spec.capacity) {
  sums_.name = spec.name;
}

void DatedStage::append(const TokenRecord& record, std::int64_t count) {
  const TokenRecord fitted = fitted_record(record, inputs_.size(), outputs_.size(), memory_ != nullptr);
  runs_.append(fitted, count);
}

DatedStage::Chunk DatedStage::startable() {
  Chunk chunk;
  std::int64_t count = std::min(runs_.left(start_), spec_.capacity - (started_ - delivered_));
  if (count <= 0) return chunk;
  const TokenRecord& record = runs_.record(start_);
  bool first_of_batch = false;
  if (spec_.batch > 1) {
    const std::int64_t position = started_ % spec_.batch;
    first_of_batch = position == 0;
    count = std::min(count, spec_.batch - position);
  }
  for (std::size_t j = 0; j < inputs_.size(); ++j) {
    if (!has(record.take, j)) continue;
    const DatedFifo& input = *inputs_[j];
    const std::int64_t held = input.held();
    if (held == 0) return chunk;
    if (first_of_batch) {
      if (held < spec_.batch && input.written != input.total) return chunk;
      chunk.gathered = std::max(chunk.gathered, input.writes[input.removed + std::min<std::int64_t>(held, spec_.batch) - 1] + 1);
    }
    if (has(record.release, j)) count = std::min(count, held);
  }
  chunk.count = count;
  return chunk;
}

bool DatedStage::start_some() {
  const Chunk chunk = startable();
  if (chunk.count == 0) return false;
  const TokenRecord& record = runs_.record(start_);
  Ports taken(inputs_, record.take), removed(inputs_, record.release);
  const Cycle to_ready = spec_.latency + record.lead;
  for (const std::int64_t end = started_ + chunk.count; started_ < end; ++started_) {
    Cycle able = std::max(free_, chunk.gathered);
    for (const DatedFifo* input : taken) able = std::max(able, input->writes[input->removed] + 1);
    const Cycle start = std::max(able, deliveries_[started_ - spec_.capacity] + 1);
    for (DatedFifo* input : removed) input->remove(start);
    Cycle ready = start + to_ready;
    if (record.misses > 0) ready = std::max(ready, memory_->request(start, record.misses) + 1);
    ready_[started_] = ready;
    sums_.starved += able - free_;
    sums_.blocked_room += start - able;
    free_ = start + record.interval;
    last_start_ = start;
  }
  sums_.busy += chunk.count * Cycle{record.interval};
  start_.used += chunk.count;
  return true;
}

std::int64_t DatedStage::deliverable() {
  if (started_ == delivered_) return 0;
  std::int64_t count = std::min(runs_.left(deliver_), started_ - delivered_);
  const TokenRecord& record = runs_.record(deliver_);
  for (std::size_t j = 0; j < outputs_.size(); ++j)
    if (has(record.give, j)) count = std::min(count, outputs_[j]->room());
  return count;
}

bool DatedStage::deliver_some() {
  const std::int64_t count = deliverable();
  if (count == 0) return false;
  Ports given(outputs_, runs_.record(deliver_).give);
  for (const std::int64_t end = delivered_ + count; delivered_ < end; ++delivered_) {
    const Cycle done = std::max(ready_[delivered_], last_delivery_ + 1);
    Cycle delivery = done;
    for (DatedFifo* output : given) {
      const Cycle freed = output->removals[output->written - output->depth];
      output->account_write(freed);
      delivery = std::max(delivery, freed + 1);
    }
    for (DatedFifo* output : given) output->write(delivery);
    sums_.blocked_output += delivery - done;
    deliveries_[delivered_] = delivery;
    last_delivery_ = delivery;
  }
  deliver_.used += count;
  return true;
}

bool DatedStage::next_is_ordinary() {
  if (!simple_ || runs_.left(start_) == 0) return false;
  const TokenRecord& record = runs_.record(start_);
  return record.misses == 0 && record.release == inputs_.size() && record.give == outputs_.size();
}

std::int64_t DatedStage::passable() {
  std::int64_t count = runs_.left(start_);
  if (!inputs_.empty()) count = std::min(count, inputs_[0]->held());
  if (!outputs_.empty()) count = std::min(count, outputs_[0]->room());
  return count;
}

/// Start and delivery of ordinary tokens, none in flight before them. Everything is kept in registers: for the compiler the dates could
/// alias.
template <bool HasInput, bool HasOutput>
void DatedStage::pass(std::int64_t count) {
  FifoView input, output;
  if constexpr (HasInput) input = view_of(*inputs_[0]);
  if constexpr (HasOutput) output = view_of(*outputs_[0]);
  Cycle* const deliveries = deliveries_.data();
  const std::uint64_t mask = deliveries_.mask();
  const std::uint64_t capacity = static_cast<std::uint64_t>(spec_.capacity);
  std::uint64_t token = static_cast<std::uint64_t>(started_);
  const TokenRecord& record = runs_.record(start_);
  const Cycle interval = record.interval;
  const Cycle to_ready = spec_.latency + record.lead;

  Cycle free = free_, start = 0, delivery = last_delivery_;
  Cycle starved = 0, blocked_room = 0, blocked_output = 0, empty = 0, full = 0;
  for (std::int64_t i = 0; i < count; ++i, ++token) {
    Cycle able = free;
    if constexpr (HasInput) {
      const Cycle arrival = input.writes[input.removed & input.mask];
      empty += std::max<Cycle>(0, arrival - input.last_removal);
      able = std::max(able, arrival + 1);
    }
    start = std::max(able, deliveries[(token - capacity) & mask] + 1);
    starved += able - free;
    blocked_room += start - able;
    free = start + interval;
    if constexpr (HasInput) {
      input.removals[input.removed++ & input.mask] = start;
      input.last_removal = start;
    }
    delivery = std::max(start + to_ready, delivery + 1);
    if constexpr (HasOutput) {
      const Cycle freed = output.removals[(output.written - output.depth) & output.mask];
      full += std::max<Cycle>(0, freed - output.last_write);
      while (output.largest < output.depth && output.writes[(output.written - output.depth + output.largest) & output.mask] < freed)
        ++output.largest;
      const Cycle done = delivery;
      delivery = std::max(done, freed + 1);
      blocked_output += delivery - done;
      output.writes[output.written++ & output.mask] = delivery;
      output.last_write = delivery;
    }
    deliveries[token & mask] = delivery;
  }

  if constexpr (HasInput) {
    inputs_[0]->removed = static_cast<std::int64_t>(input.removed);
    inputs_[0]->last_removal = input.last_removal;
    inputs_[0]->add_empty(empty);
  }
  if constexpr (HasOutput) {
    outputs_[0]->written = static_cast<std::int64_t>(output.written);
    outputs_[0]->last_write = output.last_write;
    outputs_[0]->add_full(full);
    outputs_[0]->set_largest(static_cast<std::int64_t>(output.largest));
  }
  free_ = free;
  last_start_ = start;
  last_delivery_ = delivery;
  started_ = delivered_ = static_cast<std::int64_t>(token);
  sums_.busy += count * interval;
  sums_.starved += starved;
  sums_.blocked_room += blocked_room;
  sums_.blocked_output += blocked_output;
}

void DatedStage::pass_some(std::int64_t count) {
  if (inputs_.empty())
    outputs_.empty() ? pass<false, false>(count) : pass<false, true>(count);
  else
    outputs_.empty() ? pass<true, false>(count) : pass<true, true>(count);
  start_.used += count;
  deliver_ = start_;
}

DatedStage::Progress DatedStage::date(bool eager) {
  Progress progress;
  for (;;) {
    while (deliver_some()) progress.delivered = true;
    const bool ordinary = next_is_ordinary();
    if (ordinary && started_ == delivered_) {
      const std::int64_t count = passable();
      if (count > 0) {
        pass_some(count);
        progress = {true, true};
        continue;
      }
    }
    if (ordinary && !eager) return progress;
    if (!start_some()) return progress;
    progress.started = true;
  }
}

StageStatistics DatedStage::statistics() const {
  StageStatistics result = sums_;
  result.tokens = delivered_;
  result.last_delivery = last_delivery_;
  return result;
}

}  // namespace bump
