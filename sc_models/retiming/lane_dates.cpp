#include "retiming/lane_dates.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "datapath/invariant.h"
#include "datapath/lane_clones.h"
#include "retiming/trace_feeder.h"

// Vectors are passed within this file only, where every function is built for the same machine.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace bump {

namespace {

constexpr std::size_t width = LaneDates::width;
constexpr std::int64_t longest_history = 1 << 14;  // tokens
/// Dates stay below this at the end of a block, and blocks are so short that none passes twice as much.
constexpr std::int64_t latest_date = std::int64_t{1} << 30;
constexpr std::int64_t longest_block = 1 << 14;  // tokens

/// A date for each configuration; the compiler maps it to whatever vectors the machine has.
using Dates = std::int32_t __attribute__((vector_size(4 * LaneDates::width)));

#define BUMP_INLINE inline __attribute__((always_inline))
BUMP_INLINE Dates larger(const Dates& a, const Dates& b) {
  return a > b ? a : b;
}

/// The last dates of a sequence of events, each plus one, which is when what waited for it can happen. Before the first event: 0.
struct History {
  Dates* rows = nullptr;
  std::uint32_t mask = 0;
  std::uint32_t distances = 0;                  ///< how many differ
  std::array<std::uint32_t, width> distance{};  ///< the different ones
  std::array<Dates, width> lanes{};             ///< all bits set where the lane has it

  BUMP_INLINE void write(std::uint32_t event, const Dates& dates) const { rows[event & mask] = dates; }
  /// For each lane the date of the event so far back as the lane looks.
  BUMP_INLINE Dates before(std::uint32_t event) const {
    if (distances == 1) return rows[(event - distance[0]) & mask];
    Dates found{};
    for (std::uint32_t i = 0; i < distances; ++i) found |= rows[(event - distance[i]) & mask] & lanes[i];
    return found;
  }
};

struct LaneStage {
  Dates free{}, next_delivery{};      ///< s(k-1) + ii(k-1); w(k-1) + 1
  Dates starved{}, blocked_output{};  ///< sums
  Dates interval{}, latency{};        ///< what the records add to
  History deliveries;                 ///< looked back in by the capacity
  History starts;                     ///< of the next stage, looked back in by the depth of the FIFO between
};

struct LaneMemory {
  Dates tag{}, latency{}, cycles_per_line{}, bus_free{};
  History fills;  ///< looked back in by the misses in flight
  std::uint32_t requests = 0;
};

struct Pipe {
  std::array<LaneStage, stage::count> stages;
  std::array<LaneMemory, 2> memories;
  std::uint32_t triangle = 0, fragment = 0, raster_token = 0;
  Dates triangle_arrival{};  ///< w + 1 of the triangle in the rasterizer
};

BUMP_INLINE Dates start_token(LaneStage& s, std::uint32_t token, const Dates& arrival, const Dates& interval) {
  const Dates able = larger(s.free, arrival);
  const Dates start = larger(able, s.deliveries.before(token));
  s.starved += able - s.free;
  s.free = start + interval;
  return start;
}

/// Returns w + 1.
BUMP_INLINE Dates deliver(LaneStage& s, std::uint32_t token, const Dates& delivery) {
  s.next_delivery = delivery + 1;
  s.deliveries.write(token, s.next_delivery);
  return s.next_delivery;
}

BUMP_INLINE Dates deliver_into_fifo(LaneStage& s, std::uint32_t token, std::uint32_t item, const Dates& ready) {
  const Dates done = larger(ready, s.next_delivery);
  const Dates delivery = larger(done, s.starts.before(item));
  s.blocked_output += delivery - done;
  return deliver(s, token, delivery);
}

/// Returns the fill of the last line, plus 1.
BUMP_INLINE Dates request(LaneMemory& memory, const Dates& start, std::uint32_t lines) {
  Dates fill{};
  for (std::uint32_t i = 0; i < lines; ++i) {
    const Dates grant = larger(larger(start + memory.tag, memory.bus_free), memory.fills.before(memory.requests));
    memory.bus_free = grant + memory.cycles_per_line;
    fill = grant + memory.latency + 1;
    memory.fills.write(memory.requests++, fill);
  }
  return fill;
}

/// A stage between two FIFOs whose tokens are fragments.
BUMP_INLINE Dates pass(LaneStage& s, LaneStage& before, std::uint32_t fragment, const Dates& arrival, const Dates& interval,
                       const Dates& to_ready) {
  const Dates start = start_token(s, fragment, arrival, interval);
  before.starts.write(fragment, start + 1);
  return deliver_into_fifo(s, fragment, fragment, start + to_ready);
}

BUMP_INLINE Dates pass_memory(LaneStage& s, LaneStage& before, LaneMemory& memory, std::uint32_t lines, std::uint32_t fragment,
                              const Dates& arrival, const Dates& interval, const Dates& to_ready) {
  const Dates start = start_token(s, fragment, arrival, interval);
  before.starts.write(fragment, start + 1);
  Dates ready = start + to_ready;
  if (lines > 0) ready = larger(ready, request(memory, start, lines));
  return deliver_into_fifo(s, fragment, fragment, ready);
}

BUMP_INLINE void pass_triangle(Pipe& p, const TokenStep& step) {
  LaneStage& vertex = p.stages[stage::vertex_processor];
  LaneStage& setup = p.stages[stage::triangle_setup];
  const std::uint32_t t = p.triangle++;
  const Dates none{};
  const Dates entered = start_token(vertex, t, none, none + step.first.interval);
  const Dates arrival = deliver_into_fifo(vertex, t, t, entered + (vertex.latency + step.first.lead));
  const Dates start = start_token(setup, t, arrival, none + step.second.interval);
  vertex.starts.write(t, start + 1);
  p.triangle_arrival = deliver_into_fifo(setup, t, t, start + (setup.latency + step.second.lead));
}

BUMP_INLINE Dates start_in_rasterizer(Pipe& p, const TokenStep& step) {
  LaneStage& raster = p.stages[stage::rasterizer];
  const Dates start = start_token(raster, p.raster_token, p.triangle_arrival, Dates{} + step.first.interval);
  // The triangle's index is that of the last that entered: triangles come one by one.
  if (step.releases) p.stages[stage::triangle_setup].starts.write(p.triangle - 1, start + 1);
  return start + (raster.latency + step.first.lead);
}

BUMP_INLINE void pass_dropped(Pipe& p, const TokenStep& step) {
  LaneStage& raster = p.stages[stage::rasterizer];
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const Dates ready = start_in_rasterizer(p, step);
    deliver(raster, p.raster_token++, larger(ready, raster.next_delivery));
  }
}

template <bool Maps>
BUMP_INLINE void pass_fragments(Pipe& p, const TokenStep& step) {
  std::array<LaneStage, stage::count>& s = p.stages;
  LaneStage& before_illumination = s[Maps ? stage::light_map_fetch : stage::environment];
  const Dates texture_interval = Dates{} + step.second.interval;
  const Dates texture_ready = s[stage::texture_fetch].latency + step.second.lead;
  const Dates maps_interval = larger(s[stage::light_map_fetch].interval, Dates{} + step.third.interval);
  const Dates maps_ready = s[stage::light_map_fetch].latency + step.third.lead;
  for (std::uint32_t i = 0; i < step.count; ++i) {
    const std::uint32_t f = p.fragment++;
    Dates arrival = deliver_into_fifo(s[stage::rasterizer], p.raster_token, f, start_in_rasterizer(p, step));
    ++p.raster_token;
    LaneStage& interpolators = s[stage::interpolators];
    arrival = pass(interpolators, s[stage::rasterizer], f, arrival, interpolators.interval, interpolators.latency);
    arrival = pass_memory(s[stage::texture_fetch], interpolators, p.memories[0], step.misses, f, arrival, texture_interval, texture_ready);
    LaneStage& environment = s[stage::environment];
    arrival = pass(environment, s[stage::texture_fetch], f, arrival, environment.interval, environment.latency);
    if (Maps)
      arrival =
          pass_memory(s[stage::light_map_fetch], environment, p.memories[1], step.light_misses, f, arrival, maps_interval, maps_ready);
    LaneStage& illumination = s[stage::illumination];
    arrival = pass(illumination, before_illumination, f, arrival, illumination.interval, illumination.latency);
    LaneStage& sink = s[stage::frame_sink];
    const Dates start = start_token(sink, f, arrival, sink.interval);
    illumination.starts.write(f, start + 1);
    deliver(sink, f, larger(start + sink.latency, sink.next_delivery));
  }
}

template <bool Maps>
BUMP_INLINE void pass_steps(Pipe& pipe, const TokenStep* step, const TokenStep* end) {
  for (; step != end; ++step) {
    switch (step->kind) {
      case TokenStep::Kind::triangle:
        pass_triangle(pipe, *step);
        break;
      case TokenStep::Kind::dropped:
        pass_dropped(pipe, *step);
        break;
      case TokenStep::Kind::fragments:
        pass_fragments<Maps>(pipe, *step);
        break;
    }
  }
}

BUMP_LANE_LOOP void run_steps(Pipe& pipe, const TokenStep* begin, const TokenStep* end) {
  pass_steps<false>(pipe, begin, end);
}

BUMP_LANE_LOOP void run_steps_with_maps(Pipe& pipe, const TokenStep* begin, const TokenStep* end) {
  pass_steps<true>(pipe, begin, end);
}

void set(Dates& dates, std::size_t lane, std::int64_t value) {
  dates[lane] = static_cast<std::int32_t>(value);
}

}  // namespace

struct LaneDates::State {
  Pipe pipe;
  std::vector<std::unique_ptr<Dates[]>> rows;
  std::int64_t growth = 0;  ///< the most that one token adds to any date
  bool has_maps = false;

  void make_history(History& history, const std::array<std::int64_t, width>& distance) {
    const std::int64_t longest = *std::max_element(distance.begin(), distance.end());
    std::uint32_t size = 1;
    while (size < longest) size *= 2;
    rows.push_back(std::make_unique<Dates[]>(size));
    history.rows = rows.back().get();
    history.mask = size - 1;
    for (std::size_t lane = 0; lane < width; ++lane) {
      const auto looked = static_cast<std::uint32_t>(distance[lane]);
      std::uint32_t i = 0;
      while (i < history.distances && history.distance[i] != looked) ++i;
      if (i == history.distances) history.distance[history.distances++] = looked;
      history.lanes[i][lane] = -1;
    }
  }
};

bool LaneDates::serves(const PipelineTiming& timing) {
  const TimingGraph& graph = timing.graph;
  const auto is_short = [](std::int64_t length) { return length <= longest_history; };
  return std::all_of(graph.stages.begin(), graph.stages.end(),
                     [&](const StageSpec& s) { return s.batch == 1 && is_short(s.capacity) && s.latency < latest_date; }) &&
         std::all_of(graph.fifos.begin(), graph.fifos.end(), [&](const FifoSpec& fifo) { return is_short(fifo.depth); }) &&
         std::all_of(graph.memories.begin(), graph.memories.end(), [&](const MemorySpec& memory) {
           return is_short(memory.outstanding) && memory.tag_latency + memory.latency + memory.cycles_per_line < latest_date;
         });
}

LaneDates::LaneDates(const TokenProgram& program, const std::vector<const PipelineTiming*>& timings)
    : program_(program), timings_(timings), state_(std::make_unique<State>()) {
  BUMP_ASSERT(!timings.empty() && timings.size() <= width);
  State& state = *state_;
  // Lanes that are not used repeat the last configuration.
  std::array<const PipelineTiming*, width> of_lane{};
  for (std::size_t lane = 0; lane < width; ++lane) of_lane[lane] = timings[std::min(lane, timings.size() - 1)];
  state.has_maps = of_lane[0]->place[stage::light_map_fetch] >= 0;

  std::array<std::int64_t, width> distance{};
  for (int kind = 0; kind < stage::count; ++kind) {
    const int place = of_lane[0]->place[static_cast<std::size_t>(kind)];
    if (place < 0) continue;
    const auto index = static_cast<std::size_t>(place);
    LaneStage& s = state.pipe.stages[static_cast<std::size_t>(kind)];
    for (std::size_t lane = 0; lane < width; ++lane) {
      const StageSpec& spec = of_lane[lane]->graph.stages[index];
      set(s.latency, lane, spec.latency);
      set(s.interval, lane, of_lane[lane]->interval[static_cast<std::size_t>(kind)]);
      distance[lane] = spec.capacity;
    }
    state.make_history(s.deliveries, distance);
    if (index + 1 == of_lane[0]->graph.stages.size()) continue;
    for (std::size_t lane = 0; lane < width; ++lane) distance[lane] = of_lane[lane]->graph.fifos[index].depth;
    state.make_history(s.starts, distance);
  }
  for (std::size_t m = 0; m < of_lane[0]->graph.memories.size(); ++m) {
    LaneMemory& memory = state.pipe.memories[m];
    for (std::size_t lane = 0; lane < width; ++lane) {
      const MemorySpec& spec = of_lane[lane]->graph.memories[m];
      set(memory.tag, lane, spec.tag_latency);
      set(memory.latency, lane, spec.latency);
      set(memory.cycles_per_line, lane, spec.cycles_per_line);
      distance[lane] = spec.outstanding;
    }
    state.make_history(memory.fills, distance);
  }
  for (const PipelineTiming* timing : of_lane) {
    std::int64_t growth = program.most_work;
    for (const StageSpec& spec : timing->graph.stages) growth += spec.latency + 2;
    for (const std::uint32_t interval : timing->interval) growth += interval;
    for (const MemorySpec& spec : timing->graph.memories)
      growth += program.most_misses * (spec.tag_latency + spec.latency + spec.cycles_per_line + 2);
    state.growth = std::max(state.growth, growth);
  }
}

LaneDates::~LaneDates() = default;

bool LaneDates::run(const std::atomic<bool>* cancelled) {
  State& state = *state_;
  const std::int64_t block = std::min(longest_block, latest_date / (state.growth + 1));
  if (block < 1 || !program_.complete) return false;
  const TokenStep* step = program_.steps.data();
  const TokenStep* const end = step + program_.steps.size();
  std::uint32_t done = 0;  // tokens of the step that begins the block
  while (step != end) {
    if (cancelled != nullptr && *cancelled) return false;
    const TokenStep* last = step;
    std::int64_t tokens = 0;
    while (last != end && tokens + (last->count - (last == step ? done : 0)) <= block) {
      tokens += last->count - (last == step ? done : 0);
      ++last;
    }
    const auto run = [&](const TokenStep* from, const TokenStep* to) {
      state.has_maps ? run_steps_with_maps(state.pipe, from, to) : run_steps(state.pipe, from, to);
    };
    if (done > 0 || last == step) {  // a part of a step that is longer than a block
      TokenStep part = *step;
      part.count = static_cast<std::uint32_t>(std::min<std::int64_t>(block, step->count - done));
      run(&part, &part + 1);
      done += part.count;
      if (done == step->count) {
        ++step;
        done = 0;
      }
    } else {
      run(step, last);
      step = last;
    }
    Dates latest{};
    for (const LaneStage& s : state.pipe.stages) latest = larger(latest, larger(s.free, s.next_delivery));
    for (const LaneMemory& memory : state.pipe.memories) latest = larger(latest, memory.bus_free);
    for (std::size_t lane = 0; lane < width; ++lane)
      if (latest[lane] > latest_date) return false;
  }
  return true;
}

Retimed LaneDates::result(std::size_t lane) const {
  const PipelineTiming& timing = *timings_[lane];
  Retimed retimed;
  TimingResult& result = retimed.timing;
  result.stages.resize(timing.graph.stages.size());
  retimed.last_interval.assign(timing.graph.stages.size(), 0);
  for (int kind = 0; kind < stage::count; ++kind) {
    const int place = timing.place[static_cast<std::size_t>(kind)];
    if (place < 0) continue;
    const LaneStage& s = state_->pipe.stages[static_cast<std::size_t>(kind)];
    StageStatistics& statistics = result.stages[static_cast<std::size_t>(place)];
    Cycle& last_interval = retimed.last_interval[static_cast<std::size_t>(place)];
    const Cycle own = timing.interval[static_cast<std::size_t>(kind)];
    statistics.name = timing.graph.stages[static_cast<std::size_t>(place)].name;
    statistics.tokens = kind < stage::rasterizer    ? program_.triangles
                        : kind == stage::rasterizer ? program_.raster_tokens
                                                    : program_.fragments;
    statistics.busy = statistics.tokens * own;
    if (statistics.tokens > 0) last_interval = own;
    for (std::size_t stream = 0; stream < traced::count; ++stream) {
      if (stage_of(static_cast<traced::Index>(stream)) != kind) continue;
      statistics.busy = program_.busy[stream];
      last_interval = program_.last_interval[stream];
      if (stream != traced::light_map) continue;
      statistics.busy = 0;
      for (const TokenStep& step : program_.steps)
        if (step.kind == TokenStep::Kind::fragments) statistics.busy += step.count * std::max<Cycle>(own, step.third.interval);
      if (statistics.tokens > 0) last_interval = std::max(own, last_interval);
    }
    statistics.starved = s.starved[lane];
    statistics.blocked_room = s.free[lane] - statistics.busy - statistics.starved;
    statistics.blocked_output = s.blocked_output[lane];
    statistics.last_delivery = s.next_delivery[lane] - 1;
    result.cycles = std::max(result.cycles, statistics.last_delivery + 1);
  }
  for (std::size_t i = 0; i < timing.graph.fifos.size(); ++i) {
    const FifoSpec& spec = timing.graph.fifos[i];
    result.fifos.push_back({spec.name, spec.depth, spec.to <= stage::rasterizer ? program_.triangles : program_.fragments, 0, 0, 0});
  }
  for (std::size_t m = 0; m < timing.graph.memories.size(); ++m) {
    const std::int64_t requests = m == 0 ? program_.requests : program_.light_requests;
    result.memories.push_back({timing.graph.memories[m].name, requests, requests * timing.graph.memories[m].cycles_per_line});
  }
  return retimed;
}

}  // namespace bump
