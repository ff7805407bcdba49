#include "testbench/experiments/retime.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include "retiming/lane_dates.h"
#include "retiming/trace_file.h"
#include "system/bound.h"
#include "testbench/experiments/retime_team.h"
#include "testbench/results/output_file.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// Points whose graphs are held at a time: all of a large sweep would take more memory than the trace.
constexpr std::size_t chunk_points = 4096;
/// Fragments, summed over the caches whose records are held at a time, and caches that one thread feeds at a time.
constexpr std::size_t fetched_fragments = 4'000'000, caches_together = 8;

[[noreturn]] void interrupted() {
  throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
}

/// Records that points share: those of the trace, or what other caches make of them.
struct Source {
  std::optional<FetchedTrace> fetched;
  const TimingTrace* trace = nullptr;
  TokenProgram program;
};

/// A row of the sweep and what it is made from.
struct Point {
  PipelineTiming timing;
  SweepRow* row = nullptr;
  const Source* source = nullptr;
  std::vector<std::int64_t> sizes;  ///< depths, capacities, misses in flight
};

std::vector<std::int64_t> sizes_of(const TimingGraph& graph) {
  std::vector<std::int64_t> sizes;
  for (const FifoSpec& fifo : graph.fifos) sizes.push_back(fifo.depth);
  for (const StageSpec& stage : graph.stages) sizes.push_back(stage.capacity);
  for (const MemorySpec& memory : graph.memories) sizes.push_back(memory.outstanding);
  return sizes;
}

using Group = std::vector<const Point*>;

/// Points [begin, end) of those in the order of their settings share settings `settings`.
struct Block {
  std::size_t begin = 0, end = 0, settings = 0;
};

class Sweep {
 public:
  Sweep(Retimer& retimer, const Configuration& base, const SweepPoints& points, const SweepOptions& options)
      : retimer_(retimer), configuration_(base), points_(points), options_(options), rows_(points.count) {
    order_.resize(rows_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (points.with_caches)
      sort_by_caches();
    else
      blocks_.push_back({0, rows_.size(), 0});
  }

  std::vector<SweepRow> run() {
    Team team(options_.jobs, [this] {
      if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(rows_.size() + settings_.size()));
    });
    for (std::size_t first = 0; first < blocks_.size();) {
      const std::size_t last = std::min(blocks_.size(), first + blocks_at_a_time());
      const std::vector<Source> sources = make_sources(team, first, last);
      for (std::size_t begin = blocks_[first].begin, end = blocks_[last - 1].end; begin < end; begin += chunk_points) {
        const std::vector<Point> points = prepare(begin, std::min(begin + chunk_points, end), first, sources);
        const std::vector<Group> groups = grouped(points);
        team.run(groups.size(), [&](std::size_t i) { date(groups[i]); });
      }
      first = last;
    }
    if (cancelled()) interrupted();
    return std::move(rows_);
  }

 private:
  bool cancelled() const { return options_.cancelled != nullptr && *options_.cancelled; }

  /// Points of the same caches one after another, those of the same size of line near one another.
  void sort_by_caches() {
    std::map<FetchSettings, std::vector<std::size_t>> points;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (cancelled()) interrupted();
      points_.apply(i, configuration_);
      points[retimer_.fetch_settings(configuration_)].push_back(i);
    }
    std::size_t at = 0;
    for (const auto& [settings, members] : points) {
      blocks_.push_back({at, at + members.size(), settings_.size()});
      std::copy(members.begin(), members.end(), order_.begin() + static_cast<std::ptrdiff_t>(at));
      at += members.size();
      settings_.push_back(settings);
    }
  }

  /// So many that neither their records nor their points take much memory.
  std::size_t blocks_at_a_time() const {
    const auto fragments = static_cast<std::size_t>(std::max<std::int64_t>(1, retimer_.trace().fragments()));
    return std::clamp<std::size_t>(fetched_fragments / fragments, 2, 64);
  }

  /// Of blocks [first, last). Neighbours go through the caches together, since their lines are worked out once.
  std::vector<Source> make_sources(Team& team, std::size_t first, std::size_t last) {
    std::vector<Source> sources(last - first);
    if (settings_.empty()) {
      sources.front().trace = &retimer_.trace();
      sources.front().program = make_token_program(retimer_.trace());
      return sources;
    }
    const std::size_t together = std::clamp<std::size_t>(sources.size() / team.jobs(), 1, caches_together);
    team.run((sources.size() + together - 1) / together, [&](std::size_t part) {
      const std::size_t begin = part * together, end = std::min(begin + together, sources.size());
      const std::vector<FetchSettings> settings(settings_.begin() + static_cast<std::ptrdiff_t>(first + begin),
                                                settings_.begin() + static_cast<std::ptrdiff_t>(first + end));
      std::vector<FetchedTrace> fetched = retimer_.fetch(settings, options_.cancelled);
      if (cancelled()) interrupted();
      for (std::size_t i = begin; i < end; ++i) {
        sources[i].fetched = std::move(fetched[i - begin]);
        sources[i].trace = &sources[i].fetched->trace;
        sources[i].program = make_token_program(*sources[i].trace);
        ++done_;
      }
    });
    return sources;
  }

  /// Points [begin, end) in the order of their settings; `first` is the block of the first source.
  std::vector<Point> prepare(std::size_t begin, std::size_t end, std::size_t first, const std::vector<Source>& sources) {
    std::vector<Point> points;
    std::size_t block = first;
    for (std::size_t i = begin; i < end; ++i) {
      if (cancelled()) interrupted();
      while (blocks_[block].end <= i) ++block;
      SweepRow& row = rows_[order_[i]];
      points_.apply(order_[i], configuration_);
      row.clock_megahertz = configuration_.number("clock.megahertz");
      points.push_back({retimer_.timing_of(configuration_), &row, &sources[block - first], {}});
      points.back().timing.schedules = {};
      points.back().sizes = sizes_of(points.back().timing.graph);
    }
    return points;
  }

  bool serves(const Point& point) const { return options_.vectors && point.source->program.complete && LaneDates::serves(point.timing); }

  /// Points that the vector kernel dates go together so that they differ in few depths and capacities: where all agree it is quicker.
  std::vector<Group> grouped(const std::vector<Point>& points) const {
    std::vector<Group> groups;
    Group together;
    for (const Point& point : points) {
      serves(point) ? together.push_back(&point) : groups.push_back({&point});
    }
    std::stable_sort(together.begin(), together.end(),
                     [](const Point* a, const Point* b) { return a->source != b->source ? a->source < b->source : a->sizes < b->sizes; });
    for (auto begin = together.cbegin(); begin != together.cend();) {
      auto end = begin;
      while (end != together.cend() && end - begin < static_cast<std::ptrdiff_t>(LaneDates::width) && (*end)->source == (*begin)->source)
        ++end;
      groups.emplace_back(begin, end);
      begin = end;
    }
    return groups;
  }

  void keep(const Point& point, Retimed retimed) {
    point.row->bound = lower_bound(point.timing.graph, retimed.timing, retimed.last_interval);
    point.row->cycles = retimed.timing.cycles;
    point.row->stages = std::move(retimed.timing.stages);
    ++done_;
  }

  void date(const Group& group) {
    for (const Point* point : group)
      if (point->source->fetched) point->row->traffic = point->source->fetched->traffic;
    if (serves(*group.front()) && date_at_once(group)) return;
    for (const Point* point : group) date(*point);
  }

  bool date_at_once(const Group& group) {
    std::vector<const PipelineTiming*> timings;
    for (const Point* point : group) timings.push_back(&point->timing);
    LaneDates lanes(group.front()->source->program, timings);
    if (!lanes.run(options_.cancelled)) return false;
    for (std::size_t i = 0; i < group.size(); ++i) keep(*group[i], lanes.result(i));
    return true;
  }

  void date(const Point& point) {
    const auto watch = [this](double) {
      if (cancelled()) interrupted();
    };
    try {
      keep(point, replay(*point.source->trace, point.timing, watch));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::deadlock) throw;
      point.row->error = error;
      ++done_;
    }
  }

  Retimer& retimer_;
  Configuration configuration_;
  const SweepPoints& points_;
  const SweepOptions& options_;
  std::vector<SweepRow> rows_;
  std::vector<std::size_t> order_;       ///< points in the order in which they are dated
  std::vector<Block> blocks_;            ///< of them
  std::vector<FetchSettings> settings_;  ///< distinct ones; none if no caches are swept
  std::atomic<std::size_t> done_{0};
};

}  // namespace

bool sweeps_caches(const Retimer& retimer, const Configuration& base, const SweepGrid& grid) {
  const auto is_fetch_axis = [&](const SweepAxis& axis) { return retimer.is_fetch_key(axis.key); };
  const std::vector<SweepAxis>& axes = grid.axes();
  return retimer.trace().has_addresses() && (retimer.fetches_anew(base) || std::any_of(axes.begin(), axes.end(), is_fetch_axis));
}

std::vector<SweepRow> sweep(Retimer& retimer, const Configuration& base, const SweepGrid& grid, const SweepOptions& options) {
  SweepPoints points;
  points.count = grid.points();
  points.apply = [&grid](std::size_t point, Configuration& configuration) { grid.apply(point, configuration); };
  points.with_caches = sweeps_caches(retimer, base, grid);
  return sweep(retimer, base, points, options);
}

std::vector<SweepRow> sweep(Retimer& retimer, const Configuration& base, const SweepPoints& points, const SweepOptions& options) {
  return Sweep(retimer, base, points, options).run();
}

void check_record_file(const std::string& path, const std::string& out, bool force) {
  check_output_file(path, force, "--record");
  check_replaced_file(path, trace_magic, "timing trace", "--record");
  const fs::path file = fs::weakly_canonical(fs::absolute(path)), folder = fs::weakly_canonical(fs::absolute(out));
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  (void)unused;
  if (end != folder.end()) return;
  throw Error({"the timing trace would lie in the result folder",
               {path},
               "a result folder holds the files of a result and nothing else",
               "another place for --record"});
}

}  // namespace bump
