#include "retiming/retimer.h"

#include "system/bound.h"

namespace bump {

namespace {

constexpr const char* again = "bumpsim run SCENE --record FILE makes a new one";

Error other_program(const std::string& name, const std::string& why) {
  return Error({"the timing trace was recorded by a program that differs from this one", {name}, why, again});
}

/// The recorded values, all of them and no others.
Configuration configuration_of(const TimingTrace& trace, Parameters parameters, const std::string& name) {
  Configuration configuration(std::move(parameters));
  if (trace.configuration.size() != configuration.entries().size())
    throw other_program(name, "it holds " + std::to_string(trace.configuration.size()) + " parameters, the program has " +
                                  std::to_string(configuration.entries().size()));
  for (const auto& [key, value] : trace.configuration) {
    if (configuration.parameters().find(key) == nullptr) throw other_program(name, "it has no parameter '" + key + "'");
    configuration.set_text(key, value, {name, 0, 0});
  }
  return configuration;
}

std::string quoted(const ParameterValue& value) {
  return "'" + to_string(value) + "'";
}

/// Multiplier limits and operator latencies.
bool is_schedule_key(const std::string& key) {
  const std::string limit = ".multipliers";
  return key.rfind("datapath.", 0) == 0 || (key.size() > limit.size() && key.compare(key.size() - limit.size(), limit.size(), limit) == 0);
}

}  // namespace

Retimer::Retimer(TimingTrace trace, Parameters parameters, const std::string& name)
    : trace_(std::move(trace)), name_(name), recorded_(configuration_of(trace_, std::move(parameters), name)) {
  try {
    traced_ = make_traced_design(trace_, find_scheme(trace_.scheme), recorded_);
  } catch (const Error& error) {
    throw other_program(name, error.text().what);
  }
  if (hash_of_netlists(*traced_) != trace_.netlists)
    throw other_program(name, "the datapaths of " + trace_.scheme + " are no longer the same");
  const bool has_maps = traced_->design.light_maps.has_value();
  if (has_maps ? trace_.streams[traced::light_map].tokens != trace_.fragments() : !trace_.streams[traced::light_map].runs.empty())
    throw other_program(name, "the light maps of " + trace_.scheme + " are no longer the same");
  for (const auto& [key, entry] : recorded_.entries())
    if (is_schedule_key(key)) schedule_keys_.push_back(key);
}

void Retimer::check(const Configuration& configuration) const {
  for (const auto& [key, entry] : configuration.entries()) {
    const ParameterValue& before = recorded_.entries().at(key).value;
    if (configuration.parameters().find(key)->timing_only || entry.value == before) continue;
    throw Error({key + " = " + quoted(entry.value) + " cannot be retimed: the trace was recorded with " + quoted(before), entry.origin,
                 "it is more than timing: it can change values, routes, cache hits or intervals, which the trace holds",
                 "record again: bumpsim run " + trace_.scene + " --scheme " + trace_.scheme + " --set " + key + "=" +
                     to_string(entry.value) + " --record FILE"});
  }
}

PipelineTiming Retimer::timing_of(const Configuration& configuration) {
  std::string values;
  for (const std::string& key : schedule_keys_) values += to_string(configuration.entries().at(key).value) + " ";
  auto found = schedules_.find(values);
  if (found == schedules_.end()) found = schedules_.emplace(values, make_schedules(traced_->design, traced_->colour, configuration)).first;
  return make_pipeline_timing(found->second, traced_->passes, configuration);
}

RetimedRun Retimer::retime(const Configuration& configuration, const std::function<void(double)>& watch) {
  const PipelineTiming timing = timing_of(configuration);
  Retimed retimed = replay(trace_, timing, watch);
  const bool as_recorded = [&] {
    for (const auto& [key, entry] : configuration.entries())
      if (entry.value != recorded_.entries().at(key).value) return false;
    return true;
  }();
  if (as_recorded && retimed.timing.cycles != trace_.cycles)
    throw Error(ErrorKind::self_check, {"self-check failed: the trace was recorded with " + std::to_string(trace_.cycles) + " cycles",
                                        {name_},
                                        "dated again as it was recorded it takes " + std::to_string(retimed.timing.cycles),
                                        again});
  const Bound bound = lower_bound(timing.graph, retimed.timing, retimed.last_interval);
  return {std::move(retimed.timing), bound};
}

}  // namespace bump
