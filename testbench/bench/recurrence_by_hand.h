#pragma once
// The recurrence of the timing plane as a plain loop over a recorded trace: token by token through all stages, one ring of dates for each
// stage, nothing counted but the last delivery. What dates cost at least in scalar code; it must end at the cycle count of the engines.

#include <algorithm>
#include <limits>
#include <vector>

#include "retiming/token_program.h"
#include "system/pipeline_timing.h"

namespace bump::bench {

class RecurrenceByHand {
 public:
  /// Batches are not in it: throws if a stage gathers tokens.
  explicit RecurrenceByHand(const PipelineTiming& timing) {
    for (const StageSpec& spec : timing.graph.stages) {
      if (spec.batch != 1) throw Error({"a stage gathers batches", {}, "the loop by hand takes none", ""});
      Stage stage;
      stage.latency = spec.latency;
      stage.capacity = spec.capacity;
      stages_.push_back(stage);
    }
    std::vector<std::int64_t> depths(timing.graph.stages.size(), 1);
    for (const FifoSpec& fifo : timing.graph.fifos) depths[static_cast<std::size_t>(fifo.from)] = fifo.depth;
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      stages_[i].depth = depths[i];
      std::size_t size = 1;
      while (size <= static_cast<std::size_t>(std::max(stages_[i].capacity, i > 0 ? depths[i - 1] : 1))) size *= 2;
      stages_[i].mask = size - 1;
      stages_[i].started.assign(size, before_all);
      stages_[i].delivered.assign(size, before_all);
    }
    for (const int kind :
         {stage::interpolators, stage::texture_fetch, stage::environment, stage::light_map_fetch, stage::illumination, stage::frame_sink})
      if (timing.place[static_cast<std::size_t>(kind)] >= 0) {
        Stage& stage = stages_[static_cast<std::size_t>(timing.place[static_cast<std::size_t>(kind)])];
        stage.interval = timing.interval[static_cast<std::size_t>(kind)];
        const int memory = timing.at(static_cast<stage::Index>(kind)).memory;
        if (memory >= 0) stage.port = Port(timing.graph.memories[static_cast<std::size_t>(memory)]);
      }
    texture_ = static_cast<std::size_t>(timing.place[stage::texture_fetch]);
    light_map_ = static_cast<std::size_t>(std::max(0, timing.place[stage::light_map_fetch]));
  }

  Cycle run(const TokenProgram& program) {
    for (const TokenStep& step : program.steps)
      for (std::uint32_t i = 0; i < step.count; ++i) token(step);
    return latest_ + 1;
  }

 private:
  static constexpr Cycle before_all = std::numeric_limits<Cycle>::min() / 4;
  static constexpr std::size_t vertex = 0, setup = 1, raster = 2;

  struct Port {
    Cycle tag = 0, latency = 0, line = 0, free = 0;
    std::vector<Cycle> fills;
    std::size_t next = 0;
    Port() = default;
    explicit Port(const MemorySpec& spec)
        : tag(spec.tag_latency),
          latency(spec.latency),
          line(spec.cycles_per_line),
          fills(static_cast<std::size_t>(spec.outstanding), before_all) {}
    Cycle fill(Cycle start) {
      const Cycle grant = std::max({start + tag, free, fills[next] + 1});
      free = grant + line;
      fills[next] = grant + latency;
      const Cycle date = fills[next];
      next = next + 1 == fills.size() ? 0 : next + 1;
      return date;
    }
  };

  struct Stage {
    Cycle latency = 1, interval = 1;
    std::int64_t capacity = 1, depth = 1;  ///< depth of the FIFO behind it
    std::size_t mask = 0;
    std::vector<Cycle> started, delivered;
    std::int64_t token = 0;
    Cycle free = 0;  ///< when the next token may start
    Cycle last = before_all;
    Port port;
  };

  /// Starts the stage's next token no earlier than `input`, and returns when its result is ready.
  Cycle start(Stage& stage, Cycle input, TokenStep::Work work, int misses) {
    const auto k = static_cast<std::size_t>(stage.token);
    const Cycle begin = std::max({stage.free, input, stage.delivered[(k - static_cast<std::size_t>(stage.capacity)) & stage.mask] + 1});
    stage.started[k & stage.mask] = begin;
    stage.free = begin + work.interval;
    Cycle ready = std::max(begin + work.lead + stage.latency, stage.last + 1);
    for (int m = 0; m < misses; ++m) ready = std::max(ready, stage.port.fill(begin) + 1);
    return ready;
  }

  Cycle deliver(Stage& stage, Cycle date) {
    stage.last = stage.delivered[static_cast<std::size_t>(stage.token) & stage.mask] = date;
    ++stage.token;
    latest_ = std::max(latest_, date);
    return date;
  }

  /// When the slot of token k is free that stage `from` fills.
  Cycle slot(std::size_t from, std::int64_t token) const {
    const Stage& next = stages_[from + 1];
    return next.started[static_cast<std::size_t>(token - stages_[from].depth) & next.mask] + 1;
  }

  void token(const TokenStep& step) {
    if (step.kind == TokenStep::Kind::triangle) {
      const Cycle ready = start(stages_[vertex], 0, step.first, 0);
      const Cycle in = deliver(stages_[vertex], std::max(ready, slot(vertex, stages_[vertex].token)));
      const Cycle set_up = start(stages_[setup], in + 1, step.second, 0);
      // The slot of a triangle is free when the rasterizer releases it, which is not its token: dates of releases have a ring of their own.
      const std::int64_t slot_of = stages_[setup].token - stages_[setup].depth;
      const Cycle room = slot_of < 0 ? before_all : releases_[static_cast<std::size_t>(slot_of) % releases_.size()] + 1;
      triangle_ = deliver(stages_[setup], std::max(set_up, room));
      return;
    }
    Stage& rasterizer = stages_[raster];
    Cycle ready = start(rasterizer, triangle_ + 1, step.first, 0);
    if (step.releases || step.kind == TokenStep::Kind::dropped)
      releases_[static_cast<std::size_t>(released_++) % releases_.size()] =
          rasterizer.started[static_cast<std::size_t>(rasterizer.token) & rasterizer.mask];
    if (step.kind == TokenStep::Kind::dropped) {
      deliver(rasterizer, ready);
      return;
    }
    const std::int64_t fragment = fragment_++;
    Cycle date = deliver(rasterizer, std::max(ready, slot(raster, fragment)));
    for (std::size_t i = raster + 1; i < stages_.size(); ++i) {
      Stage& stage = stages_[i];
      TokenStep::Work work{static_cast<std::int32_t>(stage.interval), 0};
      int misses = 0;
      if (i == texture_) {
        work = step.second;
        misses = step.misses;
      } else if (i == light_map_) {
        work = {std::max(work.interval, step.third.interval), step.third.lead};
        misses = step.light_misses;
      }
      ready = start(stage, date + 1, work, misses);
      date = deliver(stage, i + 1 < stages_.size() ? std::max(ready, slot(i, fragment)) : ready);
    }
  }

  std::vector<Stage> stages_;
  std::vector<Cycle> releases_ = std::vector<Cycle>(1024, before_all);  ///< the FIFO in front of the rasterizer holds no more
  std::size_t texture_ = 0, light_map_ = 0;
  std::int64_t released_ = 0, fragment_ = 0;
  Cycle triangle_ = before_all, latest_ = -1;
};

}  // namespace bump::bench
