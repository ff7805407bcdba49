#include "testbench/experiments/retime.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>

#include "retiming/lane_dates.h"
#include "system/bound.h"
#include "testbench/results/output_file.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// Points whose graphs are held at a time: all of a large sweep would take more memory than the trace.
constexpr std::size_t chunk_points = 4096;

[[noreturn]] void interrupted() {
  throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
}

/// A row of the sweep and what it is made from.
struct Point {
  PipelineTiming timing;
  SweepRow* row = nullptr;
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

/// Runs work(0) ... work(count - 1), several at a time. The first exception by index is thrown on.
class Team {
 public:
  Team(int jobs, std::function<void()> watch) : watch_(std::move(watch)) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    jobs_ = jobs > 0 ? static_cast<std::size_t>(jobs) : cores;
  }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::vector<std::exception_ptr> failures(count);
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::condition_variable finished;
    std::size_t running = std::min(jobs_, count);
    std::vector<std::thread> threads;
    const auto member = [&] {
      for (std::size_t i = next++; i < count && !failed; i = next++) {
        try {
          work(i);
        } catch (...) {
          failures[i] = std::current_exception();
          failed = true;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      --running;
      finished.notify_one();
    };
    for (std::size_t i = 0, all = running; i < all; ++i) threads.emplace_back(member);
    std::unique_lock<std::mutex> lock(mutex);
    while (!finished.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) watch_();
    lock.unlock();
    for (std::thread& thread : threads) thread.join();
    for (const std::exception_ptr& failure : failures)
      if (failure) std::rethrow_exception(failure);
  }

 private:
  std::size_t jobs_ = 1;
  std::function<void()> watch_;
};

class Sweep {
 public:
  Sweep(Retimer& retimer, const Configuration& base, const SweepGrid& grid, const SweepOptions& options)
      : retimer_(retimer), configuration_(base), grid_(grid), options_(options), rows_(grid.points()) {}

  std::vector<SweepRow> run() {
    Team team(options_.jobs, [this] {
      if (options_.progress) options_.progress(static_cast<double>(done_) / static_cast<double>(rows_.size()));
    });
    for (std::size_t begin = 0; begin < rows_.size(); begin += chunk_points) {
      const std::vector<Point> points = prepare(begin, std::min(begin + chunk_points, rows_.size()));
      const std::vector<Group> groups = grouped(points);
      team.run(groups.size(), [&](std::size_t i) { date(groups[i]); });
    }
    if (cancelled()) interrupted();
    return std::move(rows_);
  }

 private:
  bool cancelled() const { return options_.cancelled != nullptr && *options_.cancelled; }

  std::vector<Point> prepare(std::size_t begin, std::size_t end) {
    std::vector<Point> points;
    for (std::size_t i = begin; i < end; ++i) {
      if (cancelled()) interrupted();
      SweepRow& row = rows_[i];
      grid_.apply(i, configuration_);
      row.clock_megahertz = configuration_.number("clock.megahertz");
      points.push_back({retimer_.timing_of(configuration_), &row, {}});
      points.back().timing.schedules = {};
      points.back().sizes = sizes_of(points.back().timing.graph);
    }
    return points;
  }

  /// Points that the vector kernel dates go together so that they differ in few depths and capacities: where all agree it is quicker.
  std::vector<Group> grouped(const std::vector<Point>& points) const {
    std::vector<Group> groups;
    Group together;
    for (const Point& point : points) {
      const bool served = options_.vectors && program_.complete && LaneDates::serves(point.timing);
      served ? together.push_back(&point) : groups.push_back({&point});
    }
    std::stable_sort(together.begin(), together.end(), [](const Point* a, const Point* b) { return a->sizes < b->sizes; });
    for (auto begin = together.cbegin(); begin != together.cend();) {
      const auto end = begin + std::min<std::ptrdiff_t>(LaneDates::width, together.cend() - begin);
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
    if (group.size() > 1 && date_at_once(group)) return;
    for (const Point* point : group) date(*point);
  }

  bool date_at_once(const Group& group) {
    std::vector<const PipelineTiming*> timings;
    for (const Point* point : group) timings.push_back(&point->timing);
    LaneDates lanes(program_, timings);
    if (!lanes.run(options_.cancelled)) return false;
    for (std::size_t i = 0; i < group.size(); ++i) keep(*group[i], lanes.result(i));
    return true;
  }

  void date(const Point& point) {
    const auto watch = [this](double) {
      if (cancelled()) interrupted();
    };
    try {
      keep(point, replay(retimer_.trace(), point.timing, watch));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::deadlock) throw;
      point.row->error = error;
      ++done_;
    }
  }

  Retimer& retimer_;
  const TokenProgram program_ = make_token_program(retimer_.trace());
  Configuration configuration_;
  const SweepGrid& grid_;
  const SweepOptions& options_;
  std::vector<SweepRow> rows_;
  std::atomic<std::size_t> done_{0};
};

}  // namespace

std::vector<SweepRow> sweep(Retimer& retimer, const Configuration& base, const SweepGrid& grid, const SweepOptions& options) {
  return Sweep(retimer, base, grid, options).run();
}

void check_record_file(const std::string& path, const std::string& out, bool force) {
  check_output_file(path, force, "--record");
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
