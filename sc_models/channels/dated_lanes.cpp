#include "channels/dated_lanes.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "datapath/lane_clones.h"

// Vectors are passed within this file only, where every function is built for the same machine.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace bump {

namespace {

constexpr std::size_t width = DatedLanes::widest;
constexpr std::int64_t longest_pass = 512;      // tokens
constexpr std::int64_t longest_history = 1024;  // tokens in flight and in a FIFO
constexpr std::int64_t endless = std::int64_t{1} << 60;

/// Four dates; the compiler maps it to whatever vectors the machine has.
using Quad = std::int64_t __attribute__((vector_size(32)));

/// One date for each lane, as pairs of vectors, which compilers keep in registers on machines with short ones, too.
struct Dates {
  Quad low{}, high{};
  std::int64_t operator[](std::size_t lane) const { return lane < 4 ? low[lane] : high[lane - 4]; }
  void set(std::size_t lane, std::int64_t date) { (lane < 4 ? low : high)[lane % 4] = date; }
};

#define BUMP_INLINE inline __attribute__((always_inline))
BUMP_INLINE Dates operator+(const Dates& a, const Dates& b) {
  return {a.low + b.low, a.high + b.high};
}
BUMP_INLINE Dates operator+(const Dates& a, std::int64_t b) {
  return {a.low + b, a.high + b};
}
BUMP_INLINE Dates operator-(const Dates& a, const Dates& b) {
  return {a.low - b.low, a.high - b.high};
}
BUMP_INLINE Dates operator&(const Dates& a, const Dates& b) {
  return {a.low & b.low, a.high & b.high};
}
BUMP_INLINE Dates operator<(const Dates& a, const Dates& b) {
  return {a.low < b.low, a.high < b.high};
}
BUMP_INLINE void operator+=(Dates& a, const Dates& b) {
  a = a + b;
}
BUMP_INLINE Dates larger(const Dates& a, const Dates& b) {
  return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}
/// Flags are all ones or 0.
BUMP_INLINE Dates choose(const Dates& flag, const Dates& a, const Dates& b) {
  return {flag.low ? a.low : b.low, flag.high ? a.high : b.high};
}
BUMP_INLINE bool any(const Dates& flag) {
  const Quad both = flag.low | flag.high;
  return (both[0] | both[1] | both[2] | both[3]) != 0;
}
/// dates[offset[lane]] for every lane.
BUMP_INLINE Dates gather(const Cycle* dates, const std::array<std::int64_t, width>& offset) {
  return {Quad{dates[offset[0]], dates[offset[1]], dates[offset[2]], dates[offset[3]]},
          Quad{dates[offset[4]], dates[offset[5]], dates[offset[6]], dates[offset[7]]}};
}
/// Every lane's date moves on to the next lane; `first` enters.
BUMP_INLINE Dates shifted(const Dates& a, std::int64_t first) {
  return {Quad{first, a.low[0], a.low[1], a.low[2]}, Quad{a.low[3], a.high[0], a.high[1], a.high[2]}};
}
BUMP_INLINE Dates load(const Cycle* dates) {
  Dates result;
  std::memcpy(&result.low, dates, sizeof(Quad));
  std::memcpy(&result.high, dates + 4, sizeof(Quad));
  return result;
}
BUMP_INLINE void save(const Dates& a, Cycle* dates) {
  std::memcpy(dates, &a.low, sizeof(Quad));
  std::memcpy(dates + 4, &a.high, sizeof(Quad));
}

/// Rows of one date per lane.
using Row = std::array<Cycle, width>;

/// The stage in front of the lanes: a token of it need not take an item of its own.
struct Head {
  bool active = false, takes = false, releases = false;
  Cycle interval = 1, to_ready = 1;
  int misses = 0;
  Cycle free = 0, first_free = 0, start = -1, delivery = -1, last_write = -1;
  Cycle starved = 0, blocked_output = 0, full = 0;
  std::int64_t depth = 0, largest = 0, capacity = 0;
  Cycle* deliveries = nullptr;
  std::uint64_t token = 0, deliveries_mask = 0;
  Cycle* writes = nullptr;
  std::uint64_t item = 0, writes_mask = 0;
  DatedFifo* fed = nullptr;
  DatedMemory* memory = nullptr;
};

struct Vectors {
  Dates interval{}, to_ready{}, active{};
  Dates free{}, delivery{}, last_removal{}, largest{}, depth{}, gives{};
  Dates starved{}, blocked_output{}, full{}, empty{};
  /// From a row to the date that a lane needs: delivery of token k-C; start of item k-D in the next lane; write of item k-D+largest.
  std::array<std::int64_t, width> room{}, slot{}, occupant{};
  std::array<int, width> misses{};
  std::array<DatedMemory*, width> memory{};
  bool any_misses = false;
};

}  // namespace

struct DatedLanes::State {
  Head head;
  Vectors lanes;
  std::vector<Row> starts, deliveries;
};

namespace {

inline Cycle head_token(Head& h, Cycle freed) {
  Cycle able = h.free;
  if (h.takes) able = std::max(able, h.fed->writes[h.fed->removed] + 1);
  const Cycle start = std::max(able, h.deliveries[(h.token - static_cast<std::uint64_t>(h.capacity)) & h.deliveries_mask] + 1);
  if (h.releases) h.fed->remove(start);
  h.starved += able - h.free;
  h.free = start + h.interval;
  h.start = start;
  Cycle ready = start + h.to_ready;
  if (h.misses > 0) ready = std::max(ready, h.memory->request(start, h.misses) + 1);
  const Cycle done = std::max(ready, h.delivery + 1);
  h.full += std::max<Cycle>(0, freed - h.last_write);
  while (h.largest < h.depth && h.writes[(h.item - static_cast<std::uint64_t>(h.depth - h.largest)) & h.writes_mask] < freed) ++h.largest;
  const Cycle delivery = std::max(done, freed + 1);
  h.blocked_output += delivery - done;
  h.writes[h.item++ & h.writes_mask] = delivery;
  h.deliveries[h.token++ & h.deliveries_mask] = delivery;
  h.delivery = h.last_write = delivery;
  return delivery;
}

/// The rare step in which a FIFO holds more than ever before.
void count_occupants(Vectors& v, const Dates& held_more, const Dates& freed, const Cycle* delivery_row) {
  for (std::size_t i = 0; i < width; ++i) {
    if (held_more[i] == 0) continue;
    std::int64_t largest = v.largest[i];
    while (largest < v.depth[i] && delivery_row[v.occupant[i]] < freed[i]) {
      ++largest;
      v.occupant[i] += static_cast<std::int64_t>(width);
    }
    v.largest.set(i, largest);
  }
}

/// `steps` steps in which no lane changes its kind of token.
BUMP_LANE_LOOP void run_steps(Vectors& v, Head& head, Row* starts, Row* deliveries, std::int64_t steps) {
  const Dates zero{}, far_past = zero + long_ago;
  const Dates active = v.active, gives = v.gives, interval = v.interval, to_ready = v.to_ready, depth = v.depth;
  Dates free = v.free, last = v.delivery, last_removal = v.last_removal, starved, blocked_output, full, empty;
  for (std::int64_t n = 0; n < steps; ++n, ++starts, ++deliveries) {
    Cycle* const start_row = starts->data();
    Cycle* const delivery_row = deliveries->data();
    const Dates arrival = shifted(last, head.delivery);
    const Dates able = larger(free, arrival + 1);
    const Dates start = larger(able, gather(delivery_row, v.room) + 1);
    const Dates freed = choose(gives, gather(start_row, v.slot), far_past);
    starved += (able - free) & active;
    free = choose(active, start + interval, free);
    empty += larger(zero, arrival - last_removal) & active;
    last_removal = choose(active, start, last_removal);
    Dates ready = start + to_ready;
    if (v.any_misses) {
      for (std::size_t i = 0; i < width; ++i)
        if (v.misses[i] > 0) ready.set(i, std::max(ready[i], v.memory[i]->request(start[i], v.misses[i]) + 1));
    }
    const Dates done = larger(ready, last + 1);
    const Dates delivery = larger(done, freed + 1);
    full += larger(zero, freed - last) & active;  // a lane's last write is its last delivery
    blocked_output += (delivery - done) & active;
    const Dates held_more = (gather(delivery_row, v.occupant) < freed) & (v.largest < depth) & active;
    if (any(held_more)) count_occupants(v, held_more, freed, delivery_row);
    // The head's item n-D was taken by lane 0 in step n-D+1.
    if (head.active) head_token(head, start_row[static_cast<std::int64_t>(width) * (1 - head.depth)]);
    last = choose(active, delivery, last);
    save(choose(active, start, load(start_row)), start_row);
    save(choose(active, delivery, load(delivery_row)), delivery_row);
  }
  v.free = free;
  v.delivery = last;
  v.last_removal = last_removal;
  v.starved += starved;
  v.blocked_output += blocked_output;
  v.full += full;
  v.empty += empty;
}

}  // namespace

DatedLanes::DatedLanes(std::vector<DatedStage*> stages)
    : stages_(std::move(stages)), lanes_(stages_.size() - 1), state_(std::make_unique<State>()) {
  for (const DatedStage* stage : stages_) {
    history_ = std::max<std::int64_t>(history_, stage->spec_.capacity);
    for (const DatedFifo* output : stage->outputs_) history_ = std::max(history_, output->depth);
  }
  const auto rows = static_cast<std::size_t>(history_ + longest_pass + static_cast<std::int64_t>(width) + 2);
  state_->starts.assign(rows, Row{});
  state_->deliveries.assign(rows, Row{});
}

DatedLanes::~DatedLanes() = default;

bool DatedLanes::serves(const std::vector<DatedStage*>& stages) {
  if (stages.size() < 2 || stages.size() > 1 + width) return false;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const DatedStage& stage = *stages[i];
    if (stage.spec_.capacity > longest_history) return false;
    if (i + 1 == stages.size()) break;
    if (i > 0 && stage.outputs_[0]->written != stage.delivered_) return false;  // tokens and items must have the same numbers
    if (stage.outputs_[0]->depth < 2 || stage.outputs_[0]->depth > longest_history) return false;
  }
  return true;
}

std::int64_t DatedLanes::records_left() const {
  std::int64_t left = longest_pass;
  for (std::size_t i = 1; i < stages_.size(); ++i) {
    const DatedStage& stage = *stages_[i];
    left = std::min(left, std::min(stage.runs_.appended(), stage.ordinary_until_) - stage.started_);
  }
  return left;
}

void DatedLanes::load_lane(std::size_t lane) {
  Vectors& v = state_->lanes;
  DatedStage& stage = *stages_[lane + 1];
  const DatedFifo& input = *stage.inputs_[0];
  const bool gives = lane + 1 < lanes_;
  const DatedFifo* const output = gives ? stage.outputs_[0] : nullptr;
  v.free.set(lane, stage.free_);
  v.delivery.set(lane, stage.last_delivery_);
  v.last_removal.set(lane, input.last_removal);
  v.gives.set(lane, gives ? -1 : 0);
  v.depth.set(lane, gives ? output->depth : 0);
  v.largest.set(lane, gives ? output->largest() : 0);
  v.memory[lane] = stage.memory_;
  const auto rows = static_cast<std::int64_t>(width);
  const auto own = static_cast<std::int64_t>(lane);
  v.room[lane] = -stage.spec_.capacity * rows + own;
  v.slot[lane] = gives ? (1 - output->depth) * rows + own + 1 : own;
  v.occupant[lane] = gives ? (output->largest() - output->depth) * rows + own : own;
  // Token -t of lane i stands in the row of step i+1-t.
  const auto row = [&](std::int64_t t) { return static_cast<std::size_t>(history_ + own + 1 - t); };
  for (std::int64_t t = 1; t <= stage.spec_.capacity; ++t) state_->deliveries[row(t)][lane] = stage.deliveries_[stage.started_ - t];
  for (std::int64_t t = 1; gives && t <= output->depth; ++t) state_->deliveries[row(t)][lane] = output->writes[output->written - t];
  for (std::int64_t t = 1; t <= input.depth; ++t) state_->starts[row(t)][lane] = input.removals[input.removed - t];
}

void DatedLanes::load() {
  state_->lanes = Vectors{};
  for (std::size_t lane = 0; lane < lanes_; ++lane) load_lane(lane);
  DatedStage& stage = *stages_[0];
  DatedFifo& output = *stage.outputs_[0];
  Head& h = state_->head = Head{};
  h.free = h.first_free = stage.free_;
  h.start = stage.last_start_;
  h.delivery = stage.last_delivery_;
  h.last_write = output.last_write;
  h.depth = output.depth;
  h.largest = output.largest();
  h.capacity = stage.spec_.capacity;
  h.deliveries = stage.deliveries_.data();
  h.deliveries_mask = stage.deliveries_.mask();
  h.token = static_cast<std::uint64_t>(stage.started_);
  h.writes = output.writes.data();
  h.writes_mask = output.writes.mask();
  h.item = static_cast<std::uint64_t>(output.written);
  h.fed = stage.inputs_.empty() ? nullptr : stage.inputs_[0];
  h.memory = stage.memory_;
  step_ = entered_ = 0;
}

void DatedLanes::store_lane(std::size_t lane, std::int64_t tokens) {
  const Vectors& v = state_->lanes;
  DatedStage& stage = *stages_[lane + 1];
  DatedFifo& input = *stage.inputs_[0];
  const auto row = [&](std::int64_t token) { return static_cast<std::size_t>(history_ + token + 1 + static_cast<std::int64_t>(lane)); };
  const auto last = [&](std::int64_t length) { return std::max<std::int64_t>(0, tokens - length); };
  for (std::int64_t t = last(stage.spec_.capacity); t < tokens; ++t)
    stage.deliveries_[stage.started_ + t] = state_->deliveries[row(t)][lane];
  for (std::int64_t t = last(input.depth); t < tokens; ++t) input.removals[input.removed + t] = state_->starts[row(t)][lane];
  input.removed += tokens;
  input.last_removal = v.last_removal[lane];
  input.add_empty(v.empty[lane]);
  // Between two tokens of the unit all time is an interval, a wait for the input or a wait for room.
  stage.sums_.blocked_room += v.free[lane] - stage.free_ - stage.pass_busy_ - v.starved[lane];
  stage.sums_.busy += stage.pass_busy_;
  stage.pass_busy_ = 0;
  stage.sums_.starved += v.starved[lane];
  stage.sums_.blocked_output += v.blocked_output[lane];
  stage.free_ = v.free[lane];
  stage.last_start_ = v.last_removal[lane];
  stage.last_delivery_ = v.delivery[lane];
  if (lane + 1 < lanes_) {
    DatedFifo& output = *stage.outputs_[0];
    for (std::int64_t t = last(output.depth); t < tokens; ++t) output.writes[output.written + t] = state_->deliveries[row(t)][lane];
    output.written += tokens;
    output.last_write = v.delivery[lane];
    output.add_full(v.full[lane]);
    output.set_largest(v.largest[lane]);
  }
  stage.started_ += tokens;
  stage.delivered_ = stage.started_;
  stage.deliver_ = stage.start_;
}

void DatedLanes::store(std::int64_t tokens) {
  const Head& h = state_->head;
  DatedStage& stage = *stages_[0];
  DatedFifo& output = *stage.outputs_[0];
  stage.sums_.blocked_room += h.free - h.first_free - stage.pass_busy_ - h.starved;
  stage.sums_.busy += stage.pass_busy_;
  stage.pass_busy_ = 0;
  stage.sums_.starved += h.starved;
  stage.sums_.blocked_output += h.blocked_output;
  stage.free_ = h.free;
  stage.last_start_ = h.start;
  stage.last_delivery_ = h.delivery;
  stage.started_ = stage.delivered_ = static_cast<std::int64_t>(h.token);
  stage.deliver_ = stage.start_;
  output.written += tokens;
  output.last_write = h.last_write;
  output.add_full(h.full);
  output.set_largest(h.largest);
  for (std::size_t lane = 0; lane < lanes_; ++lane) store_lane(lane, tokens);
}

std::int64_t DatedLanes::prepare_head(std::int64_t limit, const std::function<bool()>& refill) {
  Head& h = state_->head;
  DatedStage& stage = *stages_[0];
  h.active = false;
  std::int64_t count = std::min(limit - entered_, stage.runs_.left(stage.start_));
  if (count <= 0) return 0;
  const TokenRecord& record = stage.runs_.record(stage.start_);
  if (record.give == 0) return 0;
  if (record.take != 0) {
    if (h.fed->held() == 0 && !refill()) return 0;
    if (record.release != 0) count = std::min(count, h.fed->held());
  }
  h.active = true;
  h.takes = record.take != 0;
  h.releases = record.release != 0;
  h.interval = record.interval;
  h.to_ready = stage.spec_.latency + record.lead;
  h.misses = record.misses;
  return count;
}

std::int64_t DatedLanes::prepare_lanes() {
  Vectors& v = state_->lanes;
  std::int64_t steps = endless;
  v.any_misses = false;
  for (std::size_t lane = 0; lane < lanes_; ++lane) {
    const std::int64_t token = step_ - 1 - static_cast<std::int64_t>(lane);
    v.active.set(lane, 0);
    v.misses[lane] = 0;
    if (token < 0) {
      steps = std::min(steps, -token);
      continue;
    }
    const std::int64_t coming = entered_ - token;  // tokens that the head has delivered so far
    if (coming <= 0) continue;
    if (!state_->head.active) steps = std::min(steps, coming);
    DatedStage& stage = *stages_[lane + 1];
    steps = std::min(steps, stage.runs_.left(stage.start_));
    const TokenRecord& record = stage.runs_.record(stage.start_);
    v.active.set(lane, -1);
    v.interval.set(lane, record.interval);
    v.to_ready.set(lane, stage.spec_.latency + record.lead);
    v.misses[lane] = record.misses;
    v.any_misses = v.any_misses || record.misses > 0;
  }
  return steps;
}

std::int64_t DatedLanes::pass(const std::function<bool()>& refill) {
  const std::int64_t limit = records_left();
  if (limit <= 0) return 0;
  load();
  std::int64_t head_steps = prepare_head(limit, refill);
  if (head_steps == 0) return 0;
  while (true) {
    std::int64_t steps = prepare_lanes();
    if (state_->head.active) steps = std::min(steps, head_steps);
    if (steps == endless) break;  // nothing in flight, and nothing comes
    const std::int64_t row = history_ + step_;
    run_steps(state_->lanes, state_->head, &state_->starts[static_cast<std::size_t>(row)],
              &state_->deliveries[static_cast<std::size_t>(row)], steps);
    step_ += steps;
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      if (state_->lanes.active[lane] == 0) continue;
      DatedStage& stage = *stages_[lane + 1];
      stage.start_.used += steps;
      stage.pass_busy_ += steps * state_->lanes.interval[lane];
    }
    if (!state_->head.active) continue;
    stages_[0]->start_.used += steps;
    stages_[0]->pass_busy_ += steps * state_->head.interval;
    entered_ += steps;
    head_steps -= steps;
    if (head_steps == 0) head_steps = prepare_head(limit, refill);
  }
  store(entered_);
  return entered_;
}

}  // namespace bump
