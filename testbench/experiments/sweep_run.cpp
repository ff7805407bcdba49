#include "testbench/experiments/sweep_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <optional>
#include <tuple>

#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/experiments/sweep_tables.h"
#include "testbench/experiments/sweep_work.h"
#include "testbench/reference/cores.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// Of the frames whose references are held at a time: some 50 bytes each.
constexpr std::int64_t pixels_at_a_time = 4'000'000;

/// References are the same for one scene, frame, filter and culling.
using ReferenceKey = std::tuple<const Scene*, std::string, std::string>;

/// A process: a group, a single point, or the full run of a point that is dated again.
struct Item {
  std::size_t group = 0;
  std::vector<std::size_t> points;
  bool is_check = false;
  ReferenceKey reference;
};

Error fault(const std::string& what, const std::string& why) {
  return Error(ErrorKind::internal, {what, {}, why, "a smaller frame or fewer processes with --jobs 1; the same command tries again"});
}

/// Tables of another part of a sweep are results of their own: those of a shard must not replace them.
void refuse_other_shard(const SweepRunOptions& options) {
  const std::optional<Shard> found = finished_shard(options.out);
  if (!found || options.shard.of == 1 || (found->index == options.shard.index && found->of == options.shard.of)) return;
  const auto name = [](const Shard& shard) {
    return shard.of == 1 ? std::string("a whole sweep") : fmt::format("shard {}/{}", shard.index, shard.of);
  };
  throw Error({"the output folder holds " + name(*found) + ", finished",
               {options.out},
               name(options.shard) + " would replace its tables by fewer rows",
               "another folder with --out, or --force to forget what is there"});
}

class SweepExecution {
 public:
  SweepExecution(const SweepPlan& plan, const SweepRunOptions& options)
      : plan_(plan), options_(options), jobs_(options.jobs > 0 ? options.jobs : cores_of_process()), journal_(options.out, options.anew) {
    for (std::size_t i = 0; i < plan.points().size(); ++i)
      if (plan.is_in(options.shard, i)) mine_.push_back(i);
    summary_.points = mine_.size();
  }

  SweepSummary run() {
    summary_.damages = journal_.damages();
    std::vector<Item> items = pending();
    add_checks(items);
    sort_by_references(items);
    if (!items.empty()) remove_sweep_tables(options_.out);
    try {
      execute(items);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cancelled) throw;
      journal_.refresh();
      throw Error(ErrorKind::cancelled, {"interrupted",
                                         {},
                                         fmt::format("{} of {} points are finished", finished(), mine_.size()),
                                         "the same command goes on where it stopped"});
    }
    write_tables();
    return std::move(summary_);
  }

 private:
  const std::string& id_of(std::size_t point) const { return plan_.points()[point].id; }
  /// Whether the sweep dates the point again. Not a matter of what is left to do: resumed sweeps tell the same of every point.
  bool is_dated(std::size_t point) const { return plan_.group_of(point).members.size() > 1; }

  std::size_t finished() const {
    return static_cast<std::size_t>(std::count_if(mine_.begin(), mine_.end(), [&](std::size_t i) { return journal_.has(id_of(i)); }));
  }

  ReferenceKey reference_of(std::size_t group) const {
    const Configuration configuration = plan_.recorded_configuration(plan_.groups()[group]);
    return {plan_.groups()[group].scene, configuration.choice("texture_fetch.filter"), configuration.choice("triangle_setup.cull")};
  }

  std::vector<Item> pending() {
    std::vector<Item> items;
    std::map<std::size_t, std::size_t> item_of_group;
    for (const std::size_t point : mine_) {
      if (journal_.has(id_of(point))) {
        ++summary_.known;
        continue;
      }
      const std::size_t group = plan_.points()[point].group;
      const auto [place, added] = item_of_group.emplace(group, items.size());
      if (added) {
        items.push_back({group, {}, false, reference_of(group)});
        ++summary_.runs;
      }
      items[place->second].points.push_back(point);
      if (is_dated(point)) ++summary_.dated;
    }
    return items;
  }

  /// Of all points that are dated again, first one of each group, those with the lowest names.
  void add_checks(std::vector<Item>& items) {
    std::map<std::size_t, std::vector<std::size_t>> groups;
    std::size_t count = 0;
    for (const std::size_t point : mine_) {
      if (!is_dated(point)) continue;
      groups[plan_.points()[point].group].push_back(point);
      ++count;
    }
    std::vector<std::tuple<std::size_t, std::string, std::size_t>> order;  // place in its group, name, point
    for (auto& [group, points] : groups) {
      std::sort(points.begin(), points.end(), [&](std::size_t a, std::size_t b) { return id_of(a) < id_of(b); });
      for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(i, id_of(points[i]), points[i]);
    }
    std::sort(order.begin(), order.end());
    const CheckShare& share = options_.check;
    const double wanted = share.is_percent ? std::ceil(share.value / 100 * static_cast<double>(count)) : share.value;
    order.resize(static_cast<std::size_t>(std::min(wanted, static_cast<double>(count))));
    for (const auto& [place, id, point] : order) {
      if (journal_.is_checked(id)) continue;
      items.push_back({plan_.points()[point].group, {point}, true, reference_of(plan_.points()[point].group)});
      ++summary_.checked;
    }
  }

  static void sort_by_references(std::vector<Item>& items) {
    std::map<ReferenceKey, std::size_t> order;
    for (const Item& item : items) order.emplace(item.reference, order.size());
    std::stable_sort(items.begin(), items.end(),
                     [&](const Item& a, const Item& b) { return order.at(a.reference) < order.at(b.reference); });
  }

  void execute(const std::vector<Item>& items) {
    for (std::size_t begin = 0; begin < items.size();) {
      std::int64_t pixels = 0;
      std::size_t end = begin;
      for (; end < items.size(); ++end) {
        if (end > begin && items[end].reference == items[end - 1].reference) continue;
        const Scene& scene = *std::get<0>(items[end].reference);
        pixels += static_cast<std::int64_t>(scene.width) * scene.height;
        if (end > begin && pixels > pixels_at_a_time) break;
      }
      execute(items, begin, end);
      begin = end;
    }
  }

  void execute(const std::vector<Item>& items, std::size_t begin, std::size_t end) {
    std::map<ReferenceKey, References> references;
    if (plan_.spec().quality)
      for (std::size_t i = begin; i < end; ++i)
        if (references.count(items[i].reference) == 0)
          references.emplace(items[i].reference,
                             draw_references(*plan_.groups()[items[i].group].scene,
                                             plan_.recorded_configuration(plan_.groups()[items[i].group]), options_.cancelled, jobs_));
    const int threads = std::max(1, jobs_ / static_cast<int>(std::min<std::size_t>(end - begin, static_cast<std::size_t>(jobs_))));
    std::vector<ChildTask> tasks;
    for (std::size_t i = begin; i < end; ++i) {
      const auto found = references.find(items[i].reference);
      tasks.push_back(task_of(items[i], found == references.end() ? nullptr : &found->second, threads));
    }
    ChildOptions child_options;
    child_options.jobs = jobs_;
    child_options.cancelled = options_.cancelled;
    if (options_.progress)
      child_options.progress = [&](double share) {
        options_.progress((static_cast<double>(begin) + share * static_cast<double>(end - begin)) / static_cast<double>(items.size()));
      };
    const std::vector<ChildOutcome> outcomes = run_in_children(tasks, child_options);
    journal_.refresh();
    for (std::size_t i = begin; i < end; ++i) take(items[i], outcomes[i - begin]);
    // After all of them, so that what stands in the journal of this batch is known.
    for (std::size_t i = begin; i < end; ++i)
      if (items[i].is_check) compare(items[i], outcomes[i - begin]);
  }

  ChildTask task_of(const Item& item, const References* references, int threads) const {
    const auto work = [this, &item, references, threads](const ReportShare& report_share) -> std::string {
      try {
        if (item.is_check) return run_point(plan_, item.points.front(), references, report_share);
        if (is_dated(item.points.front()))
          run_group(plan_, plan_.groups()[item.group], item.points, references, threads, journal_, report_share);
        else
          journal_.append(run_point(plan_, item.points.front(), references, report_share));
        return "";
      } catch (const std::bad_alloc&) {
        throw fault("out of memory", "");
      }
    };
    return {plan_.describe(item.points.front()), work};
  }

  /// A process that failed, by a fault or for want of memory, leaves rows that are not in the journal: the next sweep tries again.
  void take(const Item& item, const ChildOutcome& outcome) {
    if (!outcome.error) return;
    if (outcome.error->kind() != ErrorKind::internal) throw *outcome.error;
    if (item.is_check) return;
    for (const std::size_t point : item.points)
      if (!journal_.has(id_of(point))) failed_.emplace(point, failure_line(id_of(point), *outcome.error));
  }

  Json line_of(std::size_t point) const {
    const auto failed = failed_.find(point);
    return failed != failed_.end() && !journal_.has(id_of(point)) ? Json::parse(failed->second) : journal_.point(id_of(point));
  }

  void compare(const Item& item, const ChildOutcome& outcome) {
    const std::size_t point = item.points.front();
    if (failed_.count(point) > 0) return;
    if (outcome.error) throw *outcome.error;
    const std::string differs = difference(line_of(point), Json::parse(outcome.bytes));
    if (!differs.empty())
      throw Error(ErrorKind::self_check, {"self-check failed: " + plan_.describe(point) + " is dated wrongly",
                                          {},
                                          differs,
                                          "report this with the command that led to it"});
    journal_.append(journal_line(Json{{"checked", id_of(point)}}.dump()));
  }

  void write_tables() {
    SweepTables tables;
    for (const std::size_t point : mine_) tables.add(sweep_row(plan_, point, line_of(point)));
    summary_.statuses = tables.statuses();
    summary_.manifest = sweep_manifest(plan_, options_.version, options_.shard, tables.statuses(), tables.rows());
    tables.write(options_.out, summary_.manifest);
  }

  const SweepPlan& plan_;
  const SweepRunOptions& options_;
  int jobs_;
  SweepJournal journal_;
  std::vector<std::size_t> mine_;
  std::map<std::size_t, std::string> failed_;
  SweepSummary summary_;
};

}  // namespace

CheckShare check_share_of(const std::string& text) {
  if (text == "all") return {100, true};
  CheckShare share{0, !text.empty() && text.back() == '%'};
  const char* end = text.data() + text.size() - (share.is_percent ? 1 : 0);
  const auto [at, error] = std::from_chars(text.data(), end, share.value);
  const bool whole = share.is_percent || share.value == std::floor(share.value);
  if (error == std::errc() && at == end && whole && share.value >= 0 && share.value <= (share.is_percent ? 100 : 1e9)) return share;
  throw Error(
      {"'" + text + "' is no number of points to check", {}, "it is a number of points, a share of them, or all", "--check 3, --check 5%"});
}

Shard shard_of(const std::string& text) {
  Shard shard{0, 0};
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec == std::errc() && index.ptr != end && *index.ptr == '/') {
    const auto of = std::from_chars(index.ptr + 1, end, shard.of);
    if (of.ec == std::errc() && of.ptr == end && shard.of >= 1 && shard.of <= 100'000 && shard.index >= 1 && shard.index <= shard.of)
      return shard;
  }
  throw Error({"'" + text + "' is no shard", {}, "a shard is its number and how many there are", "--shard 1/4 to --shard 4/4"});
}

SweepSummary run_sweep(const SweepPlan& plan, const SweepRunOptions& options) {
  if (!options.anew) refuse_other_shard(options);
  return SweepExecution(plan, options).run();
}

}  // namespace bump
