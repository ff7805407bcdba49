#include "testbench/experiments/retime_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbench/experiments/retime_traffic.h"
#include "testbench/results/error_json.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

std::optional<double> ratio(double part, double whole) {
  return whole > 0 ? std::optional<double>(part / whole) : std::nullopt;
}

std::optional<double> per_cycle(std::int64_t fragments, Cycle cycles) {
  return ratio(static_cast<double>(fragments), static_cast<double>(cycles));
}

std::optional<double> per_second(double megahertz, Cycle cycles) {
  return ratio(1e6 * megahertz, static_cast<double>(cycles));
}

Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string text(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::string full(const std::optional<double>& value) {
  return value ? to_string(ParameterValue(*value)) : "";
}

std::string share(Cycle part, Cycle whole) {
  return whole > 0 ? fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole)) : "-";
}

Json stage_json(const StageStatistics& stage) {
  return {{"name", stage.name},
          {"tokens", stage.tokens},
          {"busy", stage.busy},
          {"starved", stage.starved},
          {"blocked", stage.blocked_room},
          {"blocked_output", stage.blocked_output},
          {"last_delivery", stage.last_delivery < 0 ? Json(nullptr) : Json(stage.last_delivery)}};
}

Json value_json(const ParameterValue& value) {
  return std::visit([](const auto& plain) { return Json(plain); }, value);
}

/// What was recorded, and which settings are not the recorded run's.
Json heading_json(const Retimer& retimer, const Configuration& configuration, const std::string& version) {
  const TimingTrace& trace = retimer.trace();
  Json json;
  json["schema"] = retiming_schema;
  json["schema_version"] = retiming_schema_version;
  json["version"] = version;
  json["scheme"] = trace.scheme;
  json["scene"] = {{"name", trace.scene}, {"width", trace.width}, {"height", trace.height}};
  json["inputs"] = Json::array();
  for (const Scene::InputFile& input : trace.inputs) json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  json["triangles"] = trace.triangles();
  json["fragments"] = trace.fragments();
  json["recorded_cycles"] = trace.cycles;
  json["changed"] = Json::object();
  for (const auto& [key, entry] : configuration.entries())
    if (entry.value != retimer.recorded().entries().at(key).value) json["changed"][key] = value_json(entry.value);
  return json;
}

std::string heading_text(const Retimer& retimer, const Configuration& configuration) {
  const TimingTrace& trace = retimer.trace();
  std::string changed;
  for (const auto& [key, entry] : configuration.entries())
    if (entry.value != retimer.recorded().entries().at(key).value)
      changed += (changed.empty() ? "" : ", ") + key + " = " + to_string(entry.value);
  return fmt::format("{} on {}, dated again from a trace\n{}\n", trace.scheme, trace.scene, std::string(96, '-')) +
         fmt::format("{} x {} pixels, {} triangles, {} fragments, {} cycles as recorded\n", trace.width, trace.height, trace.triangles(),
                     trace.fragments(), trace.cycles) +
         folded(changed.empty() ? "as recorded" : changed, 96, "changed: ");
}

std::string run_text(const Retimer& retimer, const Configuration& configuration, const RetimedRun& run) {
  const TimingResult& timing = run.timing;
  std::string report = heading_text(retimer, configuration) + "\n";
  report += fmt::format("  {:<20}{:>14}\n", "cycles", timing.cycles);
  report += fmt::format("  {:<20}{:>14}\n", "fragments per cycle", text(per_cycle(retimer.trace().fragments(), timing.cycles), 4));
  report +=
      fmt::format("  {:<20}{:>14}\n", "frames per second", text(per_second(configuration.number("clock.megahertz"), timing.cycles), 1));
  report += fmt::format("  {:<20}{:>14.0f}    set by {}\n", "bound, cycles", run.bound.cycles, run.bound.by);

  TextTable modules{{"modules, share of all cycles", "tokens", "busy", "starved", "blocked", "output full"}, {}, 1};
  for (const StageStatistics& s : timing.stages)
    modules.rows.push_back({s.name, std::to_string(s.tokens), share(s.busy, timing.cycles), share(s.starved, timing.cycles),
                            share(s.blocked_room, timing.cycles), share(s.blocked_output, timing.cycles)});
  TextTable memories{{"memory", "requests", "bus busy"}, {}, 1};
  for (const MemoryStatistics& m : timing.memories)
    memories.rows.push_back({m.name, std::to_string(m.requests), share(m.busy, timing.cycles)});
  TextTable fifos{{"FIFOs, share of all cycles", "depth", "most held", "full", "empty"}, {}, 1};
  for (const FifoStatistics& f : timing.fifos)
    fifos.rows.push_back({f.name, std::to_string(f.depth), std::to_string(f.max_occupancy), share(f.full_cycles, timing.cycles),
                          share(f.empty_cycles, timing.cycles)});
  const std::string caches = run.traffic ? "\n" + aligned(traffic_table(*run.traffic, retimer.light_maps())) : "";
  return report + "\n" + aligned(modules) + caches + "\n" + aligned(memories) + "\n" + aligned(fifos);
}

std::string run_csv(const Retimer& retimer, const Configuration& configuration, const RetimedRun& run) {
  const TimingResult& timing = run.timing;
  std::string report = csv_line({"module", "statistic", "value", "unit"});
  const auto line = [&](const std::string& module, const std::string& statistic, const std::string& value, const std::string& unit) {
    report += csv_line({module, statistic, value, unit});
  };
  const auto count = [&](const std::string& module, const std::string& statistic, std::int64_t value, const std::string& unit) {
    line(module, statistic, std::to_string(value), unit);
  };
  count("run", "cycles", timing.cycles, "cycles");
  count("run", "fragments", retimer.trace().fragments(), "fragments");
  line("run", "fragments_per_cycle", full(per_cycle(retimer.trace().fragments(), timing.cycles)), "fragments/cycle");
  line("run", "frames_per_second", full(per_second(configuration.number("clock.megahertz"), timing.cycles)), "frames/s");
  line("run", "bound", full(run.bound.cycles), "cycles");
  line("run", "bound_by", run.bound.by, "");
  for (const StageStatistics& s : timing.stages) {
    count(s.name, "tokens", s.tokens, "tokens");
    count(s.name, "busy", s.busy, "cycles");
    count(s.name, "starved", s.starved, "cycles");
    count(s.name, "blocked", s.blocked_room, "cycles");
    count(s.name, "blocked_output", s.blocked_output, "cycles");
    line(s.name, "last_delivery", s.last_delivery < 0 ? "" : std::to_string(s.last_delivery), "cycles");
  }
  for (const FifoStatistics& f : timing.fifos) {
    count("fifos." + f.name, "depth", f.depth, "tokens");
    count("fifos." + f.name, "items", f.items, "tokens");
    count("fifos." + f.name, "max_occupancy", f.max_occupancy, "tokens");
    count("fifos." + f.name, "full_cycles", f.full_cycles, "cycles");
    count("fifos." + f.name, "empty_cycles", f.empty_cycles, "cycles");
  }
  for (const MemoryStatistics& m : timing.memories) {
    count(m.name, "requests", m.requests, "requests");
    count(m.name, "busy", m.busy, "cycles");
  }
  if (run.traffic)
    for (const TrafficStatistic& s : traffic_statistics(*run.traffic, retimer.light_maps())) line(s.module, s.statistic, s.value, s.unit);
  return report;
}

std::string run_json(const Retimer& retimer, const Configuration& configuration, const RetimedRun& run, const std::string& version) {
  const TimingResult& timing = run.timing;
  Json json = heading_json(retimer, configuration, version);
  json["status"] = "ok";
  json["cycles"] = timing.cycles;
  json["fragments_per_cycle"] = number(per_cycle(retimer.trace().fragments(), timing.cycles));
  json["frames_per_second"] = number(per_second(configuration.number("clock.megahertz"), timing.cycles));
  json["bound"] = {{"cycles", run.bound.cycles}, {"by", run.bound.by}};
  json["modules"] = Json::array();
  for (const StageStatistics& stage : timing.stages) json["modules"].push_back(stage_json(stage));
  json["fifos"] = Json::array();
  for (const FifoStatistics& fifo : timing.fifos)
    json["fifos"].push_back({{"name", fifo.name},
                             {"depth", fifo.depth},
                             {"items", fifo.items},
                             {"max_occupancy", fifo.max_occupancy},
                             {"full_cycles", fifo.full_cycles},
                             {"empty_cycles", fifo.empty_cycles}});
  json["memory"] = Json::array();
  for (const MemoryStatistics& memory : timing.memories)
    json["memory"].push_back({{"name", memory.name}, {"requests", memory.requests}, {"busy", memory.busy}});
  if (run.traffic) add_traffic(json, *run.traffic, retimer.light_maps());
  return json.dump(2) + "\n";
}

/// "texture_fetch 12.3 %": the stage with the most of these cycles; "-" if none has any.
std::string most(const SweepRow& row, Cycle StageStatistics::*cycles) {
  const auto found = std::max_element(row.stages.begin(), row.stages.end(),
                                      [cycles](const StageStatistics& a, const StageStatistics& b) { return a.*cycles < b.*cycles; });
  if (found == row.stages.end() || (*found).*cycles == 0) return "-";
  return found->name + " " + share((*found).*cycles, row.cycles);
}

std::string reason(const Error& error) {
  return error.text().what + (error.text().try_this.empty() ? "" : "; try " + error.text().try_this);
}

std::string sweep_text(const Retimer& retimer, const Configuration& base, const SweepGrid& grid, const std::vector<SweepRow>& rows) {
  TextTable table;
  for (const SweepAxis& axis : grid.axes()) table.header.push_back(axis.key);
  for (const char* column : {"cycles", "fragments/cycle"}) table.header.push_back(column);
  if (sweeps_caches(retimer, base, grid))
    for (const std::string& column : traffic_header(retimer.light_maps())) table.header.push_back(column);
  for (const char* column : {"bound reached", "set by", "busiest", "no room in flight", "output full"}) table.header.push_back(column);
  table.left_columns = 0;
  std::size_t failed = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SweepRow& row = rows[i];
    std::vector<std::string> cells = grid.values(i);
    if (row.error) {
      ++failed;
      cells.insert(cells.end(), {"deadlock", "-"});
    } else {
      cells.insert(cells.end(), {std::to_string(row.cycles), text(per_cycle(retimer.trace().fragments(), row.cycles), 4)});
    }
    if (row.traffic)
      for (std::string& cell : traffic_cells(*row.traffic)) cells.push_back(std::move(cell));
    if (row.error) {
      cells.insert(cells.end(), {"-", reason(*row.error), "-", "-", "-"});
    } else {
      cells.insert(cells.end(), {share(static_cast<Cycle>(row.bound.cycles), row.cycles), row.bound.by, most(row, &StageStatistics::busy),
                                 most(row, &StageStatistics::blocked_room), most(row, &StageStatistics::blocked_output)});
    }
    table.rows.push_back(std::move(cells));
  }
  std::string report = heading_text(retimer, base) + fmt::format("{} points", rows.size());
  if (failed > 0) report += fmt::format(", {} of them deadlocked", failed);
  return report + "\n\n" + aligned(table);
}

std::string sweep_csv(const Retimer& retimer, const Configuration& base, const SweepGrid& grid, const std::vector<SweepRow>& rows) {
  const bool has_traffic = sweeps_caches(retimer, base, grid);
  const auto filled = std::find_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !row.stages.empty(); });
  std::vector<std::string> header;
  for (const SweepAxis& axis : grid.axes()) header.push_back(axis.key);
  for (const char* column : {"status", "cycles", "fragments_per_cycle", "frames_per_second", "bound_cycles", "bound_by"})
    header.push_back(column);
  if (has_traffic)
    for (const TrafficStatistic& s : traffic_statistics(rows.front().traffic.value(), retimer.light_maps()))
      header.push_back(s.module + "." + s.statistic);
  if (filled != rows.end())
    for (const StageStatistics& s : filled->stages)
      for (const char* statistic : {".busy", ".starved", ".blocked", ".blocked_output"}) header.push_back(s.name + statistic + "_cycles");
  header.push_back("reason");
  const auto add_traffic_cells = [&retimer](std::vector<std::string>& cells, const SweepRow& row) {
    if (row.traffic)
      for (TrafficStatistic& s : traffic_statistics(*row.traffic, retimer.light_maps())) cells.push_back(std::move(s.value));
  };
  std::string report = csv_line(header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SweepRow& row = rows[i];
    std::vector<std::string> cells = grid.values(i);
    if (row.error) {
      cells.push_back(status_of(row.error->kind()));
      cells.resize(grid.axes().size() + 6);
      add_traffic_cells(cells, row);
      cells.resize(header.size() - 1);
      cells.push_back(reason(*row.error));
    } else {
      cells.insert(cells.end(), {"ok", std::to_string(row.cycles), full(per_cycle(retimer.trace().fragments(), row.cycles)),
                                 full(per_second(row.clock_megahertz, row.cycles)), full(row.bound.cycles), row.bound.by});
      add_traffic_cells(cells, row);
      for (const StageStatistics& s : row.stages)
        for (const Cycle value : {s.busy, s.starved, s.blocked_room, s.blocked_output}) cells.push_back(std::to_string(value));
      cells.emplace_back();
    }
    report += csv_line(cells);
  }
  return report;
}

Json row_json(const Retimer& retimer, const Configuration& configuration, const SweepGrid& grid, const SweepRow& row) {
  Json entry;
  entry["parameters"] = Json::object();
  for (const SweepAxis& axis : grid.axes()) entry["parameters"][axis.key] = value_json(configuration.entries().at(axis.key).value);
  entry["status"] = row.error ? status_of(row.error->kind()) : "ok";
  if (row.traffic) add_traffic(entry, *row.traffic, retimer.light_maps());
  if (row.error) {
    entry["error"] = to_json(row.error->text());
    return entry;
  }
  entry["cycles"] = row.cycles;
  entry["fragments_per_cycle"] = number(per_cycle(retimer.trace().fragments(), row.cycles));
  entry["frames_per_second"] = number(per_second(row.clock_megahertz, row.cycles));
  entry["bound"] = {{"cycles", row.bound.cycles}, {"by", row.bound.by}};
  entry["modules"] = Json::array();
  for (const StageStatistics& stage : row.stages) entry["modules"].push_back(stage_json(stage));
  return entry;
}

std::string sweep_json(const Retimer& retimer, const Configuration& base, const SweepGrid& grid, const std::vector<SweepRow>& rows,
                       const std::string& version) {
  Json json = heading_json(retimer, base, version);
  json["status"] = "ok";
  json["points"] = rows.size();
  // Rows are written one by one, each on a line: as a tree they would take many times their text.
  std::string report = json.dump(2);
  report.resize(report.rfind('\n'));
  report += ",\n  \"rows\": [";
  Configuration configuration = base;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    grid.apply(i, configuration);
    report += (i == 0 ? "\n    " : ",\n    ") + row_json(retimer, configuration, grid, rows[i]).dump();
  }
  return report + "\n  ]\n}\n";
}

}  // namespace

std::string retimed_run_report(const Retimer& retimer, const Configuration& configuration, const RetimedRun& run, const std::string& format,
                               const std::string& version) {
  if (format == "json") return run_json(retimer, configuration, run, version);
  return format == "csv" ? run_csv(retimer, configuration, run) : run_text(retimer, configuration, run);
}

std::string sweep_report(const Retimer& retimer, const Configuration& base, const SweepGrid& grid, const std::vector<SweepRow>& rows,
                         const std::string& format, const std::string& version) {
  if (format == "json") return sweep_json(retimer, base, grid, rows, version);
  return format == "csv" ? sweep_csv(retimer, base, grid, rows) : sweep_text(retimer, base, grid, rows);
}

}  // namespace bump
