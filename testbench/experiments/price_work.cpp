#include "testbench/experiments/price_work.h"

#include <nlohmann/json.hpp>

#include "system/simulation.h"
#include "testbench/experiments/child_processes.h"

namespace bump {

namespace {

using Json = nlohmann::json;

Json to_json(const ExecutedWork& work) {
  return {{"fragments", work.fragments},
          {"executions", work.executions},
          {"texture_look_ups", work.texture_look_ups},
          {"texture_bytes", work.texture_bytes},
          {"light_map_look_ups", work.light_map_look_ups},
          {"light_map_bytes", work.light_map_bytes},
          {"light_map_bytes_written", work.light_map_bytes_written}};
}

ExecutedWork from_json(const Json& json) {
  ExecutedWork work;
  json.at("fragments").get_to(work.fragments);
  json.at("executions").get_to(work.executions);
  json.at("texture_look_ups").get_to(work.texture_look_ups);
  json.at("texture_bytes").get_to(work.texture_bytes);
  json.at("light_map_look_ups").get_to(work.light_map_look_ups);
  json.at("light_map_bytes").get_to(work.light_map_bytes);
  json.at("light_map_bytes_written").get_to(work.light_map_bytes_written);
  return work;
}

}  // namespace

ExecutedWork work_of(const SimulationResult& result) {
  ExecutedWork work;
  work.fragments = result.fragments;
  for (const UnitCost& unit : result.units) work.executions[unit.name] = unit.executions;
  work.texture_look_ups = result.texture.accesses;
  work.texture_bytes = result.texture.bytes;
  for (const LightMapUse& map : result.light_maps) {
    work.light_map_look_ups += map.counters.reads;
    work.light_map_bytes += map.counters.bytes;
    work.light_map_bytes_written += map.bytes_written;
  }
  return work;
}

std::vector<WorkOutcome> executed_work(const Scene& scene, const std::vector<const Scheme*>& schemes, const Configuration& configuration,
                                       const WorkOptions& options) {
  std::vector<ChildTask> tasks;
  for (const Scheme* scheme : schemes)
    tasks.push_back({scheme->page().id, [&scene, scheme, &configuration](const ReportShare& report_share) {
                       SimulationOptions simulation;
                       simulation.measure = false;
                       simulation.engine = Engine::untimed;
                       simulation.progress = report_share;
                       return to_json(work_of(simulate(scene, *scheme, configuration, simulation))).dump();
                     }});
  ChildOptions child_options;
  child_options.jobs = options.jobs;
  child_options.progress = options.progress;
  child_options.cancelled = options.cancelled;
  std::vector<WorkOutcome> outcomes;
  for (ChildOutcome& child : run_in_children(tasks, child_options)) {
    WorkOutcome outcome;
    if (child.error)
      outcome.error = std::move(child.error);
    else
      outcome.work = from_json(Json::parse(child.bytes));
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace bump
