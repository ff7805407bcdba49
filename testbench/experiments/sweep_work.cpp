#include "testbench/experiments/sweep_work.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "datapath/invariant.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/retime.h"
#include "testbench/experiments/sweep_columns.h"
#include "testbench/reference/row_bands.h"
#include "testbench/results/error_json.h"
#include "testbench/results/result_json.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// Points that are dated between two entries in the journal.
constexpr std::size_t points_together = 512;
/// Of them, lines that a thread makes at a time.
constexpr int lines_together = 32;
/// How many points take as long to date as a run takes, roughly: for the share of the work that is done.
constexpr double points_of_a_run = 300;
constexpr double simulation_share = 0.9;

std::string line_of(const Json& json) {
  return journal_line(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string result_line(const std::string& id, const RunReport& report, const std::vector<std::string>& warnings) {
  Json line;
  line["id"] = id;
  line["status"] = "ok";
  line["reason"] = nullptr;
  line["values"] = sweep_values(to_json(report));
  line["warnings"] = warnings;
  return line_of(line);
}

/// A run and what is said of it.
class PointRun {
 public:
  PointRun(const Scene& scene, const Scheme& scheme, Configuration configuration)
      : configuration_(std::move(configuration)),
        run_(scene, scheme, configuration_, "dated"),
        warnings_(warnings_of(scene, scheme.page(), configuration_)) {}

  void execute(const References* references, SimulationOptions options) {
    options.measure = references != nullptr;
    run_.simulate(options);
    if (references != nullptr) run_.measure(*references);
    for (const std::string& warning : run_.warnings()) warnings_.push_back(warning);
  }
  MeasuredRun& run() { return run_; }
  const Configuration& configuration() const { return configuration_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  Configuration configuration_;
  MeasuredRun run_;
  std::vector<std::string> warnings_;
};

const Schedule* schedule_of(const std::string& unit, const DatapathSchedules& schedules) {
  if (unit == "conversion") return &schedules.conversion;
  if (unit == "environment") return &schedules.environment;
  if (unit == "light_map_address") return &schedules.light_map_address;
  if (unit == "illumination") return &schedules.illumination;
  return unit == "colour" ? &schedules.colour : nullptr;
}

/// The recorded run's results with the time of another configuration in place of its own.
class DatedReport {
 public:
  explicit DatedReport(PointRun& recorded) : result_(without_frames(recorded.run().result())), report_(recorded.run().report()) {
    report_.result = &result_;
    report_.configuration = nullptr;
  }
  /// For another thread.
  DatedReport(const DatedReport& other) : result_(other.result_), report_(other.report_) { report_.result = &result_; }
  DatedReport& operator=(const DatedReport&) = delete;

  const RunReport& with(const SweepRow& row, const DatapathSchedules& schedules) {
    result_.timing = {};
    result_.timing.cycles = row.cycles;
    result_.timing.stages = row.stages;
    result_.bound = row.bound;
    result_.clock_megahertz = row.clock_megahertz;
    for (UnitCost& unit : result_.units) {
      const Schedule* schedule = schedule_of(unit.name, schedules);
      if (schedule != nullptr && unit.pipeline)
        unit.pipeline = {schedule->latency, schedule->initiation_interval, schedule->multipliers_built};
    }
    if (!row.traffic) return report_;
    result_.texture = row.traffic->texture;
    BUMP_ASSERT(row.traffic->light_maps.size() == result_.light_maps.size());
    for (std::size_t i = 0; i < result_.light_maps.size(); ++i) {
      const std::int64_t clipped = result_.light_maps[i].counters.clipped;  // a matter of values
      result_.light_maps[i].counters = row.traffic->light_maps[i];
      result_.light_maps[i].counters.clipped = clipped;
    }
    return report_;
  }

 private:
  static SimulationResult without_frames(SimulationResult result) {
    result.hardware = result.exact = {};
    result.diverged = {};
    return result;
  }

  SimulationResult result_;
  RunReport report_;
};

/// Dates the points of a group.
class GroupDating {
 public:
  GroupDating(const SweepPlan& plan, PointRun& recorded, TimingTrace trace, bool with_caches, int threads)
      : plan_(plan),
        recorded_(recorded),
        report_(recorded),
        retimer_(std::move(trace), recorded.configuration().parameters(), "the sweep"),
        configuration_(recorded.configuration()),
        with_caches_(with_caches) {
    options_.jobs = threads;
  }

  /// Lines of all points, in their order.
  std::string lines(const std::vector<std::size_t>& points) {
    std::vector<std::string> lines(points.size());
    std::vector<std::size_t> sound;  // index into points
    for (std::size_t i = 0; i < points.size(); ++i) {
      try {
        check(points[i]);
        sound.push_back(i);
      } catch (const Error& error) {
        lines[i] = failure_line(id_of(points[i]), error);
      }
    }
    date(points, sound, lines);
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
  }

 private:
  const std::string& id_of(std::size_t point) const { return plan_.points()[point].id; }

  /// Throws what a run of the point would say before it begins.
  void check(std::size_t point) {
    plan_.apply(point, configuration_);
    retimer_.fetch_settings(configuration_);
    retimer_.check(configuration_);
    retimer_.timing_of(configuration_);
  }

  void date(const std::vector<std::size_t>& points, const std::vector<std::size_t>& chosen, std::vector<std::string>& lines) {
    if (chosen.empty()) return;
    SweepPoints sweep_points;
    sweep_points.count = chosen.size();
    sweep_points.with_caches = with_caches_;
    sweep_points.apply = [&](std::size_t i, Configuration& configuration) { plan_.apply(points[chosen[i]], configuration); };
    std::vector<SweepRow> rows;
    try {
      rows = sweep(retimer_, recorded_.configuration(), sweep_points, options_);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      // A cache that cannot hold what one of the points asks for: which of them, is seen one by one.
      if (chosen.size() == 1)
        lines[chosen.front()] = failure_line(id_of(points[chosen.front()]), error);
      else
        for (const std::size_t index : chosen) date(points, {index}, lines);
      return;
    }
    std::vector<DatapathSchedules> schedules(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].error) continue;
      plan_.apply(points[chosen[i]], configuration_);
      schedules[i] = retimer_.timing_of(configuration_).schedules;
    }
    // Making a line of a row takes longer than dating it.
    for_row_bands(static_cast<int>(rows.size()), lines_together, options_.jobs, [&](int first, int end) {
      DatedReport report(report_);
      for (int at = first; at < end; ++at) {
        const auto i = static_cast<std::size_t>(at);
        const std::string& id = id_of(points[chosen[i]]);
        lines[chosen[i]] =
            rows[i].error ? failure_line(id, *rows[i].error) : result_line(id, report.with(rows[i], schedules[i]), recorded_.warnings());
      }
    });
  }

  const SweepPlan& plan_;
  PointRun& recorded_;
  DatedReport report_;
  Retimer retimer_;
  Configuration configuration_;
  bool with_caches_;
  SweepOptions options_;
};

}  // namespace

std::string failure_line(const std::string& id, const Error& error) {
  Json line;
  line["id"] = id;
  line["status"] = status_of(error.kind());
  line["reason"] = reason_of(error);
  line["values"] = nullptr;
  line["warnings"] = Json::array();
  return line_of(line);
}

std::string run_point(const SweepPlan& plan, std::size_t point, const References* references, const ReportShare& report_share) {
  const std::string& id = plan.points()[point].id;
  const PointGroup& group = plan.group_of(point);
  try {
    PointRun run(*group.scene, *group.scheme, plan.configuration_of(point));
    SimulationOptions options;
    options.progress = [&](double share) { report_share(simulation_share * share); };
    run.execute(references, options);
    return result_line(id, run.run().report(), run.warnings());
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) throw;
    return failure_line(id, error);
  }
}

void run_group(const SweepPlan& plan, const PointGroup& group, const std::vector<std::size_t>& wanted, const References* references,
               int threads, const SweepJournal& journal, const ReportShare& report_share) {
  const double work = points_of_a_run + static_cast<double>(wanted.size());
  PointRun recorded(*group.scene, *group.scheme, plan.recorded_configuration(group));
  TraceRecorder recorder;
  SimulationOptions options;
  options.record = [&recorder](const TimingRecords& records) { recorder.add(records); };
  if (group.varies_caches) options.accesses = &recorder.accesses();
  options.progress = [&](double share) { report_share(share * points_of_a_run / work); };
  try {
    recorded.execute(references, options);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::internal) throw;
    std::string lines;
    for (const std::size_t point : wanted) lines += failure_line(plan.points()[point].id, error);
    journal.append(lines);
    return;
  }
  TimingTrace trace = recorder.finish(*group.scene, *group.scheme, recorded.configuration(), recorded.run().result().timing.cycles);
  GroupDating dating(plan, recorded, std::move(trace), group.varies_caches, threads);
  for (std::size_t begin = 0; begin < wanted.size(); begin += points_together) {
    const std::size_t end = std::min(begin + points_together, wanted.size());
    journal.append(dating.lines({wanted.begin() + static_cast<std::ptrdiff_t>(begin), wanted.begin() + static_cast<std::ptrdiff_t>(end)}));
    report_share((points_of_a_run + static_cast<double>(end)) / work);
  }
}

std::string difference(const Json& retimed, const Json& run) {
  if (retimed["status"] != run["status"])
    return "it is '" + retimed["status"].get<std::string>() + "', and '" + run["status"].get<std::string>() + "' by a run of its own";
  if (!run["values"].is_array()) return "";
  const std::vector<std::string>& columns = sweep_columns();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (retimed["values"][i] != run["values"][i])
      return columns[i] + " is " + retimed["values"][i].dump() + ", and " + run["values"][i].dump() + " by a run of its own";
  return retimed["warnings"] == run["warnings"] ? "" : "its warnings differ from those of a run of its own";
}

}  // namespace bump
