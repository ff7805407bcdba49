#include "channels/dated_chain.h"

#include <algorithm>
#include <utility>

#include "channels/fifo_sums.h"

namespace bump {

namespace {

/// Tokens that are dated before they are counted: few enough for their dates to stay in the nearest caches.
constexpr std::int64_t tokens_at_a_time = 256;

/// Stages and FIFOs that hold more are dated one by one: the buffers of all stages have room for what one of them holds.
constexpr std::int64_t most_held = 1024;

/// Behind the head: takes and removes an item, and gives one to whoever follows.
bool passes_on(const TokenRecord& record, bool last) {
  return record.release != 0 && (record.give != 0 || last);
}

}  // namespace

DatedChain::DatedChain(const TimingGraph& graph, std::vector<DatedStage*> stages) : stages_(std::move(stages)), first_(stages_.size()) {
  const auto feeds_only = [&](std::size_t stage, std::size_t next) {
    const std::vector<int> outputs = graph.outputs_of(static_cast<int>(stage));
    return outputs.size() == 1 && graph.fifos[static_cast<std::size_t>(outputs[0])].to == static_cast<int>(next) &&
           graph.inputs_of(static_cast<int>(next)).size() == 1;
  };
  const auto fits = [&](std::size_t stage) {
    const std::vector<int> outputs = graph.outputs_of(static_cast<int>(stage));
    const bool shallow = std::all_of(outputs.begin(), outputs.end(),
                                     [&](int fifo) { return graph.fifos[static_cast<std::size_t>(fifo)].depth <= most_held; });
    return shallow && graph.stages[stage].capacity <= most_held && graph.stages[stage].batch == 1 &&
           graph.inputs_of(static_cast<int>(stage)).size() <= 1;
  };
  if (stages_.empty() || !graph.outputs_of(static_cast<int>(stages_.size()) - 1).empty() || !fits(stages_.size() - 1)) return;
  std::size_t first = stages_.size() - 1;
  while (first > 0 && fits(first - 1) && feeds_only(first - 1, first)) --first;
  if (stages_.size() - first < 2) return;
  first_ = first;
  for (std::size_t i = first; i < stages_.size(); ++i) {
    history_ = std::max(history_, stages_[i]->spec_.capacity);
    if (i > first) history_ = std::max(history_, stages_[i]->inputs_[0]->depth);
  }
  room_ = std::max(tokens_at_a_time, 2 * history_);
}

bool DatedChain::can_load() {
  for (std::size_t i = first_; i < stages_.size(); ++i) {
    const DatedStage& stage = *stages_[i];
    if (stage.started_ != stage.delivered_) return false;
    if (i == first_) continue;
    const DatedFifo& input = *stage.inputs_[0];
    if (input.held() != 0) return false;
    // Once it had tokens of another kind: tokens and items have different numbers for ever.
    if (input.removed != stage.started_ || (!stage.outputs_.empty() && stage.outputs_[0]->written != stage.delivered_)) {
      first_ = i + 1 < stages_.size() ? i : stages_.size();
      return can_load();
    }
  }
  return first_ < stages_.size();
}

void DatedChain::load_link(std::size_t i) {
  Link& link = links_[i];
  DatedStage& stage = *stages_[first_ + i];
  link.free = link.first_free = stage.free_;
  link.memory = stage.memory_;
  link.read_at = link.until = next_;
  std::vector<Cycle>&starts = buffers_[2 * i], &deliveries = buffers_[2 * i + 1];
  link.starts = starts.data();
  link.deliveries = deliveries.data();
  link.room = link.deliveries - stage.spec_.capacity;
  if (i > 0) {
    const DatedFifo& input = *stage.inputs_[0];
    for (std::int64_t t = 1; t <= input.depth; ++t) link.starts[next_ - t] = input.removals[input.removed - t];
    link.starts[next_ - 1] = input.last_removal;
    for (std::int64_t t = 1; t <= stage.spec_.capacity; ++t) link.deliveries[next_ - t] = stage.deliveries_[stage.delivered_ - t];
    link.deliveries[next_ - 1] = stage.last_delivery_;
  }
  if (stage.outputs_.empty()) {
    link.freed = buffers_.back().data();
    return;
  }
  const DatedFifo& output = *stage.outputs_[0];
  link.depth = output.depth;
  link.largest = output.largest();
  for (std::int64_t t = 1; t <= output.depth; ++t) link.deliveries[next_ - t] = output.writes[output.written - t];
  link.deliveries[next_ - 1] = output.last_write;
  link.freed = buffers_[2 * i + 2].data() - output.depth;
}

void DatedChain::load() {
  const std::size_t count = stages_.size() - first_;
  links_.assign(count, {});
  // Starts and deliveries of each stage, and what stands behind the last.
  buffers_.assign(2 * count + 1, std::vector<Cycle>(static_cast<std::size_t>(history_ + room_), long_ago));
  next_ = counted_ = history_;
  passed_ = 0;
  for (std::size_t i = 0; i < count; ++i) load_link(i);
  const DatedStage& stage = *stages_[first_];
  head_ = {stage.last_start_, stage.last_delivery_, stage.inputs_.empty() ? nullptr : stage.inputs_[0]};
  loaded_ = true;
}

void DatedChain::settle_link(std::size_t i) {
  const Link& link = links_[i];
  DatedStage& stage = *stages_[first_ + i];
  stage.start_.used += next_ - link.read_at;
  stage.deliver_ = stage.start_;
  stage.free_ = link.free;
  stage.sums_.busy += link.busy;
  stage.sums_.starved += link.starved;
  // From first to last all time in front of the unit is an interval, a wait for the input or a wait for room.
  stage.sums_.blocked_room += link.free - link.first_free - link.busy - link.starved;
  stage.sums_.blocked_output += link.blocked_output;
  if (i == 0) {
    stage.last_start_ = head_.start;
    stage.last_delivery_ = head_.delivery;
  } else {
    stage.started_ += passed_;
    stage.delivered_ = stage.started_;
    stage.last_start_ = link.starts[next_ - 1];
    stage.last_delivery_ = link.deliveries[next_ - 1];
    for (std::int64_t t = std::min(passed_, stage.spec_.capacity); t > 0; --t)
      stage.deliveries_[stage.delivered_ - t] = link.deliveries[next_ - t];
    DatedFifo& input = *stage.inputs_[0];
    input.removed += passed_;
    input.last_removal = link.starts[next_ - 1];
    input.add_empty(links_[i - 1].empty);
    for (std::int64_t t = std::min(passed_, input.depth); t > 0; --t) input.removals[input.removed - t] = link.starts[next_ - t];
  }
  if (stage.outputs_.empty()) return;
  DatedFifo& output = *stage.outputs_[0];
  output.written += passed_;
  output.last_write = link.deliveries[next_ - 1];
  output.add_full(link.full);
  output.set_largest(link.largest);
  for (std::int64_t t = std::min(passed_, output.depth); t > 0; --t) output.writes[output.written - t] = link.deliveries[next_ - t];
}

void DatedChain::settle() {
  if (!loaded_) return;
  count();
  for (std::size_t i = 0; i < links_.size(); ++i) settle_link(i);
  loaded_ = false;
}

void DatedChain::retire() {
  settle();
  first_ = stages_.size();
}

Cycle DatedChain::latest() const {
  if (!loaded_) return -1;
  Cycle date = head_.delivery;
  for (const Link& link : links_) date = std::max(date, link.deliveries[next_ - 1]);
  return date;
}

bool DatedChain::read_record(std::size_t i) {
  Link& link = links_[i];
  DatedStage& stage = *stages_[first_ + i];
  stage.start_.used += next_ - link.read_at;
  link.read_at = link.until = next_;
  const std::int64_t left = stage.runs_.left(stage.start_);
  if (left == 0) return false;
  const TokenRecord& record = stage.runs_.record(stage.start_);
  if (i > 0 && !passes_on(record, stage.outputs_.empty())) return false;
  link.interval = record.interval;
  link.to_ready = stage.spec_.latency + record.lead;
  link.misses = record.misses;
  link.until = next_ + left;
  return true;
}

DatedChain::Step DatedChain::next_step(const std::function<bool()>& refill) {
  DatedStage& stage = *stages_[first_];
  if (links_[0].until == next_ && !read_record(0)) return {};
  const TokenRecord& record = stage.runs_.record(stage.start_);
  std::int64_t count = links_[0].until - next_;
  if (record.take != 0) {
    if (head_.fed->held() == 0 && !refill()) return {};
    if (record.release != 0) count = std::min(count, head_.fed->held());
  }
  if (record.give == 0) return {count, false};
  for (std::size_t i = 1; i < links_.size(); ++i) {
    if (links_[i].until == next_ && !read_record(i)) return {};
    count = std::min(count, links_[i].until - next_);
  }
  return {std::min(count, history_ + room_ - next_), true};
}

inline Cycle DatedChain::begin_head(const TokenRecord& record) {
  Link& link = links_[0];
  DatedStage& stage = *stages_[first_];
  Cycle able = link.free;
  if (record.take != 0) able = std::max(able, head_.fed->writes[head_.fed->removed] + 1);
  const Cycle start = std::max(able, stage.deliveries_[stage.started_ - stage.spec_.capacity] + 1);
  if (record.release != 0) head_.fed->remove(start);
  link.starved += able - link.free;
  link.free = start + link.interval;
  head_.start = start;
  Cycle ready = start + link.to_ready;
  if (link.misses > 0) ready = std::max(ready, link.memory->request(start, link.misses) + 1);
  return std::max(ready, head_.delivery + 1);
}

inline void DatedChain::end_head(Cycle delivery) {
  DatedStage& stage = *stages_[first_];
  stage.deliveries_[stage.started_] = head_.delivery = delivery;
  stage.delivered_ = ++stage.started_;
}

void DatedChain::drop_at_head(std::int64_t tokens) {
  DatedStage& stage = *stages_[first_];
  const TokenRecord record = stage.runs_.record(stage.start_);
  for (std::int64_t k = 0; k < tokens; ++k) end_head(begin_head(record));
  links_[0].busy += tokens * links_[0].interval;
  stage.start_.used += tokens;
  links_[0].until -= tokens;
}

void DatedChain::pass_on(std::int64_t tokens) {
  const TokenRecord record = stages_[first_]->runs_.record(stages_[first_]->start_);
  Link& head = links_[0];
  Link* const end = links_.data() + links_.size();
  const Index until = next_ + tokens;
  for (Index k = next_; k < until; ++k) {
    const Cycle head_done = begin_head(record);
    Cycle arrival = std::max(head_done, head.freed[k] + 1);
    head.blocked_output += arrival - head_done;
    head.deliveries[k] = arrival;
    end_head(arrival);
    for (Link* link = &head + 1; link != end; ++link) {
      const Cycle free = link->free;
      const Cycle able = std::max(free, arrival + 1);
      const Cycle start = std::max(able, link->room[k] + 1);
      Cycle ready = std::max(start + link->to_ready, link->deliveries[k - 1] + 1);
      const Cycle freed = link->freed[k] + 1;
      if (link->misses > 0) ready = std::max(ready, link->memory->request(start, link->misses) + 1);
      arrival = std::max(ready, freed);
      link->starved += able - free;
      link->blocked_output += arrival - ready;
      link->free = start + link->interval;
      link->starts[k] = start;
      link->deliveries[k] = arrival;
    }
  }
  next_ = until;
  passed_ += tokens;
  for (Link& link : links_) link.busy += tokens * link.interval;
}

void DatedChain::count() {
  for (std::size_t i = 0; i + 1 < links_.size(); ++i) {
    Link& link = links_[i];
    const FifoSums sums =
        fifo_sums(link.deliveries + counted_, links_[i + 1].starts + counted_, next_ - counted_, link.depth, link.largest);
    link.full += sums.full;
    link.empty += sums.empty;
    link.largest = sums.largest;
  }
  counted_ = next_;
}

void DatedChain::rewind() {
  count();
  const Index by = next_ - history_;
  for (std::size_t i = 0; i + 1 < buffers_.size(); ++i) std::copy(buffers_[i].begin() + by, buffers_[i].end(), buffers_[i].begin());
  for (Link& link : links_) {
    link.read_at -= by;
    link.until -= by;
  }
  next_ = counted_ = history_;
}

/// The last stage behind the head whose next token goes its own way; 0 if there is none.
std::size_t DatedChain::own_way() {
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    DatedStage& stage = *stages_[first_ + i];
    if (links_[i].until == next_ && !read_record(i) && stage.runs_.left(stage.start_) > 0) return i;
  }
  return 0;
}

/// The next token waits for nothing but a record of a later stage: the stages in front of that can be dated one by one.
bool DatedChain::head_could_go() const {
  if (links_[0].until == next_) return false;
  const DatedStage& stage = *stages_[first_];
  return stage.runs_.record(stage.start_).take == 0 || head_.fed->held() > 0;
}

bool DatedChain::pass(const std::function<bool()>& refill) {
  bool moved = false;
  while (loaded_ || can_load()) {
    if (!loaded_) load();
    for (Step step; (step = next_step(refill)).tokens > 0; moved = true) {
      if (step.gives)
        pass_on(step.tokens);
      else
        drop_at_head(step.tokens);
      if (next_ == history_ + room_) rewind();
    }
    const std::size_t head = own_way();
    if (head == 0) {
      if (head_could_go()) settle();
      break;
    }
    settle();
    first_ = first_ + head + 1 < stages_.size() ? first_ + head : stages_.size();
  }
  if (loaded_)  // records of tokens that have passed are free
    for (std::size_t i = first_; i < stages_.size(); ++i) stages_[i]->deliver_ = stages_[i]->start_;
  return moved;
}

}  // namespace bump
