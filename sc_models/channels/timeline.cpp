#include "channels/timeline.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>

#include "channels/dated_chain.h"
#include "channels/dated_stage.h"
#include "channels/deadlock_analysis.h"

namespace bump {

struct Timeline::State {
  explicit State(const TimingGraph& specification) : graph(specification) {
    graph.validate();
    for (const FifoSpec& fifo : graph.fifos) fifos.emplace_back(fifo);
    for (const MemorySpec& memory : graph.memories) memories.emplace_back(memory);
    for (std::size_t i = 0; i < graph.stages.size(); ++i) {
      const int memory = graph.stages[i].memory;
      stages.emplace_back(graph.stages[i], pointers(graph.inputs_of(static_cast<int>(i))), pointers(graph.outputs_of(static_cast<int>(i))),
                          memory < 0 ? nullptr : &memories[static_cast<std::size_t>(memory)]);
    }
    touched.assign(stages.size(), 0);
    producers.resize(stages.size());
    consumers.resize(stages.size());
    for (const FifoSpec& fifo : graph.fifos) {
      producers[static_cast<std::size_t>(fifo.to)].push_back(static_cast<std::size_t>(fifo.from));
      consumers[static_cast<std::size_t>(fifo.from)].push_back(static_cast<std::size_t>(fifo.to));
    }
    std::vector<DatedStage*> in_order;
    for (DatedStage& each : stages) in_order.push_back(&each);
    chain.emplace(graph, std::move(in_order));
  }

  std::vector<DatedFifo*> pointers(const std::vector<int>& indices) {
    std::vector<DatedFifo*> found;
    for (const int index : indices) found.push_back(&fifos[static_cast<std::size_t>(index)]);
    return found;
  }

  DatedStage& stage(int index) {
    BUMP_ASSERT(index >= 0 && static_cast<std::size_t>(index) < stages.size() && !finished);
    touched[static_cast<std::size_t>(index)] = 1;
    return stages[static_cast<std::size_t>(index)];
  }

  /// Visits stages with news from first to last, again and again: one sweep moves as many tokens as the shallowest FIFO holds.
  void advance() {
    do {
      for (bool again = true; again;) {
        again = false;
        for (std::size_t i = 0; i < stages.size(); ++i) {
          if (i == chain->first()) again |= pass_chain();
          if (touched[i]) again |= visit(i, false);
        }
      }
      // Where paths meet again, a stage may have to wait for a start that was left for later.
      for (std::size_t i = 0; i < stages.size(); ++i) visit(i, true);
    } while (std::find(touched.begin(), touched.end(), char{1}) != touched.end());
    for (DatedStage& each : stages) each.drop_delivered();
  }

  /// Dates the stages in front of the chain as far as its input has room. True if the input holds anything then.
  bool refill_chain() {
    const std::size_t first = chain->first();
    for (const std::size_t previous : producers[first]) touched[previous] = 1;
    for (bool again = !producers[first].empty(); again;) {
      again = false;
      for (std::size_t i = 0; i < first; ++i)
        if (touched[i]) again |= visit(i, false);
    }
    return stages[first].has_input();
  }

  /// Takes tokens through the chain at the end of the graph. True if a stage in front of it was marked.
  bool pass_chain() {
    if (!chain->pass(refill) || chain->first() == stages.size()) return false;
    for (const std::size_t previous : producers[chain->first()]) touched[previous] = 1;
    return !producers[chain->first()].empty();
  }

  /// Dates what stage i can, and marks its neighbours. True if an earlier stage was marked.
  bool visit(std::size_t i, bool eager) {
    touched[i] = 0;
    if (chain->holds(i)) return false;
    const DatedStage::Progress progress = stages[i].date(eager);
    if (progress.delivered)
      for (const std::size_t next : consumers[i]) touched[next] = 1;
    if (!progress.started) return false;
    for (const std::size_t previous : producers[i]) touched[previous] = 1;
    return !producers[i].empty();
  }

  UntimedState untimed() const {
    UntimedState state;
    for (const DatedStage& each : stages) state.stages.push_back({each.started(), each.delivered(), each.undelivered()});
    for (const DatedFifo& fifo : fifos) state.fifos.push_back({fifo.written, fifo.removed});
    return state;
  }

  Cycle latest() const {
    Cycle date = chain->latest();
    for (const DatedStage& each : stages) date = std::max(date, each.last_delivery());
    return date;
  }

  TimingGraph graph;
  std::deque<DatedFifo> fifos;  // deques: stages hold pointers
  std::deque<DatedMemory> memories;
  std::deque<DatedStage> stages;
  std::optional<DatedChain> chain;
  std::function<bool()> refill = [this] { return refill_chain(); };
  std::vector<std::vector<std::size_t>> producers, consumers;  ///< neighbours of each stage
  std::vector<char> touched;                                   ///< stages with new records or newly dated neighbours
  bool finished = false;
};

Timeline::Timeline(const TimingGraph& graph) : state_(std::make_unique<State>(graph)) {}
Timeline::~Timeline() = default;

void Timeline::append(int stage, const TokenRecord* records, std::size_t count) {
  DatedStage& target = state_->stage(stage);
  for (std::size_t i = 0, alike; i < count; i += alike) {
    for (alike = 1; i + alike < count && same_record(records[i], records[i + alike]);) ++alike;
    target.append(records[i], static_cast<std::int64_t>(alike));
  }
}

void Timeline::append_uniform(int stage, const TokenRecord& record, std::size_t count) {
  state_->stage(stage).append(record, static_cast<std::int64_t>(count));
}

void Timeline::advance() {
  state_->advance();
}

Cycle Timeline::latest() const {
  return state_->latest();
}

TimingResult Timeline::finish() {
  State& s = *state_;
  BUMP_ASSERT(!s.finished);
  s.advance();
  s.chain->retire();
  s.finished = true;

  // Only now is the last item of each stream known, and with it the batches that need not fill up.
  const UntimedState before = s.untimed();
  require_matching_items(s.graph, before);
  const std::vector<std::int64_t> totals = UntimedReplay(s.graph, before).totals();
  for (std::size_t f = 0; f < s.fifos.size(); ++f) s.fifos[f].total = totals[f];
  std::fill(s.touched.begin(), s.touched.end(), char{1});
  s.advance();

  const UntimedState after = s.untimed();
  Cycle last_move = s.latest();
  bool stuck = false;
  for (std::size_t i = 0; i < s.stages.size(); ++i) {
    last_move = std::max(last_move, s.stages[i].last_start());
    stuck |= !after.stages[i].runs.empty();
  }
  if (stuck) report_deadlock(analyse_deadlock(s.graph, after, last_move));

  TimingResult result;
  result.cycles = s.latest() + 1;
  for (const DatedStage& stage : s.stages) result.stages.push_back(stage.statistics());
  for (const DatedFifo& fifo : s.fifos) result.fifos.push_back(fifo.statistics(result.cycles));
  for (const DatedMemory& memory : s.memories) result.memories.push_back(memory.statistics());
  return result;
}

}  // namespace bump
