#include "channels/deadlock_analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "datapath/error.h"

namespace bump {

namespace {

/// What a stage must do next: start a token (and so free input slots) or deliver one.
struct Step {
  int stage = 0;
  bool start = true;
  bool operator==(const Step& other) const { return stage == other.stage && start == other.start; }
};

class WaitGraph {
 public:
  WaitGraph(const TimingGraph& graph, const UntimedState& state)
      : graph_(graph), state_(state), totals_(UntimedReplay(graph, state).totals()) {}

  /// Why the step cannot be taken, and which step it waits for; nothing when the stage has no tokens left.
  std::optional<std::pair<Deadlock::Wait, Step>> wait_of(const Step& step) const {
    return step.start ? start_wait(step) : delivery_wait(step);
  }

  /// Follows the waits from the last stage that has tokens until they close a cycle (or end at a stage without tokens).
  std::vector<Deadlock::Wait> chain() const {
    std::vector<Step> steps;
    std::vector<Deadlock::Wait> waits;
    Step next = first_step();
    while (std::find(steps.begin(), steps.end(), next) == steps.end()) {
      const auto wait = wait_of(next);
      if (!wait) return waits;
      steps.push_back(next);
      waits.push_back(wait->first);
      next = wait->second;
    }
    const auto entry = std::find(steps.begin(), steps.end(), next) - steps.begin();
    waits.erase(waits.begin(), waits.begin() + entry);
    steps.erase(steps.begin(), steps.begin() + entry);
    // Any step of the cycle could come first; the most downstream stage that cannot start names the missing items.
    const auto later = [](const Step& a, const Step& b) { return std::pair(a.start, a.stage) < std::pair(b.start, b.stage); };
    std::rotate(waits.begin(), waits.begin() + (std::max_element(steps.begin(), steps.end(), later) - steps.begin()), waits.end());
    return waits;
  }

 private:
  std::int64_t held(int fifo) const { return state_.fifos[index(fifo)].written - state_.fifos[index(fifo)].released; }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const UntimedState::Stage& stage(const Step& step) const { return state_.stages[index(step.stage)]; }

  const TokenRecord* record_at(const UntimedState::Stage& stage, std::int64_t token) const {
    std::int64_t offset = token - stage.delivered;
    for (const TokenRun& run : stage.runs) {
      if (offset < run.count) return &run.record;
      offset -= run.count;
    }
    return nullptr;
  }

  Step first_step() const {
    Step found;
    for (std::size_t i = 0; i < state_.stages.size(); ++i) {
      const UntimedState::Stage& candidate = state_.stages[i];
      if (candidate.runs.empty()) continue;
      found = {static_cast<int>(i), record_at(candidate, candidate.started) != nullptr};
    }
    return found;
  }

  std::optional<std::pair<Deadlock::Wait, Step>> start_wait(const Step& step) const {
    const StageSpec& spec = graph_.stages[index(step.stage)];
    const TokenRecord* record = record_at(stage(step), stage(step).started);
    if (record == nullptr) return std::nullopt;
    const std::vector<int> inputs = graph_.inputs_of(step.stage);
    for (std::size_t j = 0; j < inputs.size(); ++j) {
      if (((record->take >> j) & 1U) == 0) continue;
      const FifoSpec& fifo = graph_.fifos[index(inputs[j])];
      const bool ended = state_.fifos[index(inputs[j])].written == totals_[index(inputs[j])];
      const std::int64_t needed = !ended && stage(step).started % spec.batch == 0 ? spec.batch : 1;
      if (held(inputs[j]) >= needed) continue;
      const std::string reason = fmt::format("needs {} item{}, holds {} of {}{}", needed, needed == 1 ? "" : "s", held(inputs[j]),
                                             fifo.depth, ended ? ", no more will come" : "");
      return std::pair(Deadlock::Wait{spec.name, fifo.name, reason, graph_.stages[index(fifo.from)].name}, delivery_of(fifo.from));
    }
    const std::string reason = fmt::format("holds {} of {} tokens", stage(step).started - stage(step).delivered, spec.capacity);
    return std::pair(Deadlock::Wait{spec.name, "", reason, spec.name}, Step{step.stage, false});
  }

  /// The step that brings the next item out of a stage: a delivery if a token is in flight, else a start.
  Step delivery_of(int of) const { return {of, state_.stages[index(of)].started == state_.stages[index(of)].delivered}; }

  std::optional<std::pair<Deadlock::Wait, Step>> delivery_wait(const Step& step) const {
    const TokenRecord* record = record_at(stage(step), stage(step).delivered);
    if (record == nullptr) return std::nullopt;
    const std::vector<int> outputs = graph_.outputs_of(step.stage);
    for (std::size_t j = 0; j < outputs.size(); ++j) {
      const FifoSpec& fifo = graph_.fifos[index(outputs[j])];
      if (((record->give >> j) & 1U) == 0 || held(outputs[j]) < fifo.depth) continue;
      const std::string reason = fmt::format("needs a free slot, holds {} of {}", held(outputs[j]), fifo.depth);
      return std::pair(Deadlock::Wait{graph_.stages[index(step.stage)].name, fifo.name, reason, graph_.stages[index(fifo.to)].name},
                       Step{fifo.to, true});
    }
    return std::nullopt;
  }

  const TimingGraph& graph_;
  const UntimedState& state_;
  std::vector<std::int64_t> totals_;
};

/// Searches changes of one number, then of several.
class RemedySearch {
 public:
  RemedySearch(const TimingGraph& graph, const UntimedState& state)
      : graph_(graph), state_(state), totals_(UntimedReplay(graph, state).totals()) {}

  std::string text() {
    std::string best;
    std::int64_t least = 0;
    const auto consider = [&](std::int64_t& number, std::int64_t enough, const auto& describe) {
      const std::int64_t now = number;
      const std::int64_t found = smallest(number, enough);
      if (found > 0 && (best.empty() || found - now < least)) {
        least = found - now;
        best = fmt::format("{} at least {}", describe(), found);
      }
    };
    // Only a full FIFO or a full stage keeps a token from moving, so no other single change can help.
    for (std::size_t f = 0; f < graph_.fifos.size(); ++f)
      if (state_.fifos[f].written - state_.fifos[f].released == graph_.fifos[f].depth)
        consider(graph_.fifos[f].depth, totals_[f], [&] { return depth_of(f); });
    for (std::size_t i = 0; i < graph_.stages.size(); ++i)
      if (state_.stages[i].started - state_.stages[i].delivered == graph_.stages[i].capacity)
        consider(graph_.stages[i].capacity, graph_.stages[i].capacity + remaining(i),
                 [&] { return "capacity of " + graph_.stages[i].name; });
    return best.empty() ? several() : best;
  }

 private:
  bool completes() const { return UntimedReplay(graph_, state_).run(); }
  std::string depth_of(std::size_t fifo) const { return "depth of fifos." + graph_.fifos[fifo].name; }
  std::int64_t remaining(std::size_t stage) const {
    std::int64_t sum = 0;
    for (const TokenRun& run : state_.stages[stage].runs) sum += run.count;
    return sum;
  }

  /// The smallest value of `number`, up to `enough`, with which every token passes; 0 if there is none. Leaves it unchanged.
  std::int64_t smallest(std::int64_t& number, std::int64_t enough) const {
    const std::int64_t before = number;
    const auto works = [&](std::int64_t value) {
      number = value;
      const bool yes = completes();
      number = before;
      return yes;
    };
    std::int64_t fails = before;
    std::int64_t passes = before;
    do {
      if (passes >= enough) return 0;
      fails = passes;
      passes = std::min(enough, passes * 2);
    } while (!works(passes));
    while (passes - fails > 1) {
      const std::int64_t middle = fails + (passes - fails) / 2;
      (works(middle) ? passes : fails) = middle;
    }
    return passes;
  }

  /// Deep enough everywhere, then each FIFO in turn as shallow as the others allow.
  std::string several() {
    const std::vector<FifoSpec> before = graph_.fifos;
    for (std::size_t f = 0; f < before.size(); ++f) graph_.fifos[f].depth = std::max(before[f].depth, totals_[f]);
    if (!completes()) return "no depth or capacity frees it";
    std::string text;
    for (std::size_t f = 0; f < before.size(); ++f) {
      const std::int64_t enough = graph_.fifos[f].depth;
      graph_.fifos[f].depth = before[f].depth;
      if (completes()) continue;
      graph_.fifos[f].depth = smallest(graph_.fifos[f].depth, enough);
      text += fmt::format("{}{} at least {}", text.empty() ? "" : " and ", depth_of(f), graph_.fifos[f].depth);
    }
    return text;
  }

  TimingGraph graph_;
  const UntimedState& state_;
  std::vector<std::int64_t> totals_;
};

}  // namespace

void require_matching_items(const TimingGraph& graph, const UntimedState& state) {
  std::vector<std::int64_t> removed;
  for (const UntimedState::Fifo& fifo : state.fifos) removed.push_back(fifo.released);
  for (std::size_t i = 0; i < graph.stages.size(); ++i) {
    const std::vector<int> inputs = graph.inputs_of(static_cast<int>(i));
    std::int64_t in_flight = state.stages[i].started - state.stages[i].delivered;
    for (const TokenRun& run : state.stages[i].runs) {
      const std::int64_t begun = std::min(in_flight, run.count);
      in_flight -= begun;
      for (std::size_t j = 0; j < inputs.size(); ++j)
        if ((run.record.release >> j) & 1U) removed[static_cast<std::size_t>(inputs[j])] += run.count - begun;
    }
  }
  const std::vector<std::int64_t> given = UntimedReplay(graph, state).totals();
  for (std::size_t f = 0; f < graph.fifos.size(); ++f) {
    if (given[f] == removed[f]) continue;
    throw Error(ErrorKind::self_check,
                {fmt::format("FIFO {} is given {} items, but {} are removed from it", graph.fifos[f].name, given[f], removed[f]),
                 {},
                 "the token records of the stages at its two ends contradict each other",
                 "report this with the command that led to it"});
  }
}

Deadlock analyse_deadlock(const TimingGraph& graph, const UntimedState& state, Cycle cycle) {
  Deadlock deadlock;
  deadlock.cycle = cycle;
  deadlock.chain = WaitGraph(graph, state).chain();
  deadlock.remedy = RemedySearch(graph, state).text();
  return deadlock;
}

}  // namespace bump
