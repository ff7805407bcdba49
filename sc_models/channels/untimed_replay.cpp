#include "channels/untimed_replay.h"

#include <algorithm>

namespace bump {

UntimedReplay::UntimedReplay(const TimingGraph& graph, const UntimedState& state) : graph_(graph), fifos_(state.fifos) {
  for (const UntimedState::Fifo& fifo : fifos_) totals_.push_back(fifo.written);
  for (std::size_t i = 0; i < graph.stages.size(); ++i) {
    Stage stage;
    stage.inputs = graph.inputs_of(static_cast<int>(i));
    stage.outputs = graph.outputs_of(static_cast<int>(i));
    stage.started = state.stages[i].started;
    stage.delivered = state.stages[i].delivered;
    std::int64_t in_flight = stage.started - stage.delivered;
    for (const TokenRun& run : state.stages[i].runs) {
      stage.runs.append(run.record, run.count);
      for (std::size_t j = 0; j < stage.outputs.size(); ++j)
        if ((run.record.give >> j) & 1U) totals_[static_cast<std::size_t>(stage.outputs[j])] += run.count;
    }
    while (in_flight > 0) {
      const std::int64_t step = std::min(in_flight, stage.runs.left(stage.start));
      stage.start.used += step;
      in_flight -= step;
    }
    stages_.push_back(std::move(stage));
  }
}

std::int64_t UntimedReplay::held(int fifo) const {
  const UntimedState::Fifo& f = fifos_[static_cast<std::size_t>(fifo)];
  return f.written - f.released;
}

std::int64_t UntimedReplay::startable(const StageSpec& spec, Stage& stage) const {
  std::int64_t count = std::min(stage.runs.left(stage.start), spec.capacity - (stage.started - stage.delivered));
  if (count <= 0) return 0;
  const TokenRecord& record = stage.runs.record(stage.start);
  const std::int64_t gathered = stage.started % spec.batch;
  if (spec.batch > 1) count = std::min(count, spec.batch - gathered);
  for (std::size_t j = 0; j < stage.inputs.size(); ++j) {
    if (((record.take >> j) & 1U) == 0) continue;
    const int fifo = stage.inputs[j];
    const bool ended = fifos_[static_cast<std::size_t>(fifo)].written == totals_[static_cast<std::size_t>(fifo)];
    const std::int64_t needed = gathered == 0 && !ended ? spec.batch : 1;
    if (held(fifo) < needed) return 0;
    if ((record.release >> j) & 1U) count = std::min(count, held(fifo));
  }
  return count;
}

std::int64_t UntimedReplay::deliverable(Stage& stage) const {
  std::int64_t count = std::min(stage.runs.left(stage.deliver), stage.started - stage.delivered);
  if (count <= 0) return 0;
  const TokenRecord& record = stage.runs.record(stage.deliver);
  for (std::size_t j = 0; j < stage.outputs.size(); ++j)
    if ((record.give >> j) & 1U)
      count = std::min(count, graph_.fifos[static_cast<std::size_t>(stage.outputs[j])].depth - held(stage.outputs[j]));
  return count;
}

bool UntimedReplay::move(const StageSpec& spec, Stage& stage) {
  bool moved = false;
  while (const std::int64_t count = startable(spec, stage)) {
    const TokenRecord& record = stage.runs.record(stage.start);
    for (std::size_t j = 0; j < stage.inputs.size(); ++j)
      if ((record.release >> j) & 1U) fifos_[static_cast<std::size_t>(stage.inputs[j])].released += count;
    stage.started += count;
    stage.start.used += count;
    moved = true;
  }
  while (const std::int64_t count = deliverable(stage)) {
    const TokenRecord& record = stage.runs.record(stage.deliver);
    for (std::size_t j = 0; j < stage.outputs.size(); ++j)
      if ((record.give >> j) & 1U) fifos_[static_cast<std::size_t>(stage.outputs[j])].written += count;
    stage.delivered += count;
    stage.deliver.used += count;
    moved = true;
  }
  return moved;
}

bool UntimedReplay::run() {
  bool moved = true;
  while (moved) {
    moved = false;
    for (std::size_t i = 0; i < stages_.size(); ++i) moved |= move(graph_.stages[i], stages_[i]);
  }
  return std::all_of(stages_.begin(), stages_.end(), [](Stage& s) { return s.runs.left(s.deliver) == 0; });
}

}  // namespace bump
