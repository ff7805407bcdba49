#include "channels/dated_chain.h"

#include <algorithm>
#include <array>
#include <utility>

namespace bump {

namespace {

/// A stage and the FIFO behind it, for an inner loop: for the compiler, dates and counts in the objects themselves could alias.
struct Link {
  // Stage.
  Cycle interval = 1, to_ready = 1, free = 0, start = -1, delivery = -1;
  Cycle starved = 0, blocked_output = 0, first_free = 0;
  Cycle* deliveries = nullptr;
  std::uint64_t deliveries_mask = 0, token = 0, capacity = 0;
  DatedMemory* memory = nullptr;
  int misses = 0;
  // FIFO.
  Cycle *writes = nullptr, *removals = nullptr;
  std::uint64_t writes_mask = 0, removals_mask = 0, item = 0, depth = 0, largest = 0;
  Cycle last_write = -1, last_removal = -1, full = 0, empty = 0;
};

template <std::size_t... I, class Body>
void each_stage(std::index_sequence<I...>, const Body& body) {
  (body(std::integral_constant<std::size_t, I>{}), ...);
}

}  // namespace

DatedChain::DatedChain(const TimingGraph& graph, std::vector<DatedStage*> stages) : stages_(std::move(stages)), first_(stages_.size()) {
  const auto feeds_only = [&](std::size_t stage, std::size_t next) {
    const std::vector<int> outputs = graph.outputs_of(static_cast<int>(stage));
    return outputs.size() == 1 && graph.fifos[static_cast<std::size_t>(outputs[0])].to == static_cast<int>(next) &&
           graph.inputs_of(static_cast<int>(next)).size() == 1;
  };
  const auto fits = [&](std::size_t stage) {
    return graph.stages[stage].batch == 1 && graph.inputs_of(static_cast<int>(stage)).size() <= 1;
  };
  if (stages_.empty() || !graph.outputs_of(static_cast<int>(stages_.size()) - 1).empty() || !fits(stages_.size() - 1)) return;
  std::size_t first = stages_.size() - 1;
  while (first > 0 && stages_.size() - first < longest && fits(first - 1) && feeds_only(first - 1, first)) --first;
  if (stages_.size() - first >= 2) first_ = first;
}

bool DatedChain::can_pass() const {
  for (std::size_t i = first_; i < stages_.size(); ++i) {
    if (stages_[i]->started_ != stages_[i]->delivered_) return false;
    if (i > first_ && stages_[i]->inputs_[0]->held() != 0) return false;
  }
  return first_ < stages_.size();
}

std::int64_t DatedChain::startable(const TokenRecord& record) const {
  DatedStage& stage = *stages_[first_];
  const std::int64_t count = stage.runs_.left(stage.start_);
  if (count == 0 || record.take == 0) return count;
  const std::int64_t held = stage.inputs_[0]->held();
  if (held == 0) return 0;
  return record.release != 0 ? std::min(count, held) : count;
}

std::int64_t DatedChain::alike() {
  DatedStage& stage = *stages_[first_];
  if (stage.runs_.left(stage.start_) == 0) return 0;
  const TokenRecord& record = stage.runs_.record(stage.start_);
  std::int64_t count = startable(record);
  if (record.give == 0) return count;
  for (std::size_t i = first_ + 1; i < stages_.size() && count > 0; ++i) {
    DatedStage& next = *stages_[i];
    count = std::min(count, next.runs_.left(next.start_));
    if (count == 0) break;
    const TokenRecord& behind = next.runs_.record(next.start_);
    if (behind.release != 0 && (behind.give != 0 || next.outputs_.empty())) continue;
    first_ = i + 1 < stages_.size() ? i : stages_.size();  // this stage goes its own way
    return 0;
  }
  return count;
}

template <std::size_t Stages>
void DatedChain::run(std::int64_t count) {
  std::array<Link, Stages> links;
  DatedFifo* const fed = stages_[first_]->inputs_.empty() ? nullptr : stages_[first_]->inputs_[0];
  const TokenRecord head = stages_[first_]->runs_.record(stages_[first_]->start_);
  for (std::size_t i = 0; i < Stages; ++i) {
    Link& link = links[i];
    DatedStage& stage = *stages_[first_ + i];
    const TokenRecord& record = stage.runs_.record(stage.start_);
    link.interval = record.interval;
    link.to_ready = stage.spec_.latency + record.lead;
    link.free = link.first_free = stage.free_;
    link.delivery = stage.last_delivery_;
    link.deliveries = stage.deliveries_.data();
    link.deliveries_mask = stage.deliveries_.mask();
    link.token = static_cast<std::uint64_t>(stage.started_);
    link.capacity = static_cast<std::uint64_t>(stage.spec_.capacity);
    link.memory = stage.memory_;
    link.misses = record.misses;
    if (i + 1 == Stages) break;
    DatedFifo& fifo = *stage.outputs_[0];
    link.writes = fifo.writes.data();
    link.removals = fifo.removals.data();
    link.writes_mask = fifo.writes.mask();
    link.removals_mask = fifo.removals.mask();
    link.item = static_cast<std::uint64_t>(fifo.written);
    link.depth = static_cast<std::uint64_t>(fifo.depth);
    link.largest = static_cast<std::uint64_t>(fifo.largest());
    link.last_write = fifo.last_write;
    link.last_removal = fifo.last_removal;
  }

  for (std::int64_t k = 0; k < count; ++k) {
    Cycle arrival = long_ago;  // w of the item in the stage before
    if (head.take != 0) arrival = fed->writes[fed->removed];
    each_stage(std::make_index_sequence<Stages>{}, [&](auto stage) {
      constexpr std::size_t i = decltype(stage)::value;
      Link& s = links[i];
      const Cycle able = std::max(s.free, arrival + 1);
      const Cycle start = std::max(able, s.deliveries[(s.token - s.capacity) & s.deliveries_mask] + 1);
      s.starved += able - s.free;
      s.free = start + s.interval;
      s.start = start;
      if constexpr (i > 0) {
        Link& before = links[i - 1];
        before.empty += std::max<Cycle>(0, arrival - before.last_removal);
        before.removals[(before.item - 1) & before.removals_mask] = start;
        before.last_removal = start;
      } else if (head.release != 0) {
        fed->remove(start);
      }
      Cycle ready = start + s.to_ready;
      if (s.misses > 0) ready = std::max(ready, s.memory->request(start, s.misses) + 1);
      Cycle delivery = std::max(ready, s.delivery + 1);
      if constexpr (i + 1 < Stages) {
        const Cycle freed = s.removals[(s.item - s.depth) & s.removals_mask];
        s.full += std::max<Cycle>(0, freed - s.last_write);
        while (s.largest < s.depth && s.writes[(s.item - s.depth + s.largest) & s.writes_mask] < freed) ++s.largest;
        const Cycle done = delivery;
        delivery = std::max(done, freed + 1);
        s.blocked_output += delivery - done;
        s.writes[s.item++ & s.writes_mask] = delivery;
        s.last_write = delivery;
      }
      s.deliveries[s.token++ & s.deliveries_mask] = delivery;
      s.delivery = arrival = delivery;
    });
  }

  for (std::size_t i = 0; i < Stages; ++i) {
    const Link& link = links[i];
    DatedStage& stage = *stages_[first_ + i];
    stage.free_ = link.free;
    stage.last_start_ = link.start;
    stage.last_delivery_ = link.delivery;
    stage.started_ = stage.delivered_ = static_cast<std::int64_t>(link.token);
    stage.start_.used += count;
    stage.deliver_ = stage.start_;
    stage.sums_.busy += count * link.interval;
    stage.sums_.starved += link.starved;
    // From first to last all time in front of the unit is an interval, a wait for the input or a wait for room.
    stage.sums_.blocked_room += link.free - link.first_free - count * link.interval - link.starved;
    stage.sums_.blocked_output += link.blocked_output;
    if (i + 1 == Stages) break;
    DatedFifo& fifo = *stage.outputs_[0];
    fifo.written = fifo.removed = static_cast<std::int64_t>(link.item);
    fifo.last_write = link.last_write;
    fifo.last_removal = link.last_removal;
    fifo.add_full(link.full);
    fifo.add_empty(link.empty);
    fifo.set_largest(static_cast<std::int64_t>(link.largest));
  }
}

void DatedChain::run(std::size_t stages, std::int64_t count) {
  static_assert(longest == 12);
  switch (stages) {
    case 1:
      return run<1>(count);
    case 2:
      return run<2>(count);
    case 3:
      return run<3>(count);
    case 4:
      return run<4>(count);
    case 5:
      return run<5>(count);
    case 6:
      return run<6>(count);
    case 7:
      return run<7>(count);
    case 8:
      return run<8>(count);
    case 9:
      return run<9>(count);
    case 10:
      return run<10>(count);
    case 11:
      return run<11>(count);
    default:
      return run<12>(count);
  }
}

DatedLanes* DatedChain::lanes() {
  if (lanes_first_ == first_ && lanes_) return lanes_.get();
  lanes_.reset();
  lanes_first_ = first_;
  std::vector<DatedStage*> chain(stages_.begin() + static_cast<std::ptrdiff_t>(first_), stages_.end());
  if (DatedLanes::serves(chain)) lanes_ = std::make_unique<DatedLanes>(std::move(chain));
  return lanes_.get();
}

bool DatedChain::pass(const std::function<bool()>& refill) {
  bool moved = false;
  while (can_pass()) {
    const std::size_t first = first_;
    const std::int64_t count = alike();
    if (first != first_) continue;
    if (count == 0) break;
    const DatedStage& stage = *stages_[first_];
    moved = true;
    if (stage.runs_.record(stage.start_).give == 0) {
      run<1>(count);
      continue;
    }
    DatedLanes* const kernel = lanes();
    if (kernel == nullptr || kernel->pass(refill) == 0) run(stages_.size() - first_, count);
  }
  return moved;
}

}  // namespace bump
