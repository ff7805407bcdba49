#include "retiming/retimer.h"

#include <algorithm>

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
  fetch_keys_ = TextureFetchConfig::look_up_keys();
  if (has_maps)
    for (const std::string& key : LightMapFetchConfig::look_up_keys()) fetch_keys_.push_back(key);
}

void Retimer::check(const Configuration& configuration) const {
  for (const auto& [key, entry] : configuration.entries()) {
    const ParameterValue& before = recorded_.entries().at(key).value;
    if (configuration.parameters().find(key)->timing_only || entry.value == before || is_unused(key)) continue;
    const bool needs_addresses = is_fetch_key(key);
    if (needs_addresses && trace_.has_addresses()) continue;
    if (needs_addresses)
      throw Error({key + " = " + quoted(entry.value) + " cannot be retimed: the trace holds no addresses", entry.origin,
                   "it was recorded with " + quoted(before) + ", and what other caches find follows from the addresses",
                   "record again, with the addresses: " + command_again({}, " --addresses")});
    throw Error({key + " = " + quoted(entry.value) + " cannot be retimed: the trace was recorded with " + quoted(before), entry.origin,
                 "it is more than timing: it can change values, routes, cache hits or intervals, which the trace holds",
                 "record again: " + command_again({key, to_string(entry.value)})});
  }
  if (!fetches_anew(configuration)) return;
  const FetchSettings settings = fetch_settings(configuration);
  if (const LightMaps* maps = light_maps()) LightMapFetch::layout_of(*maps, settings.light_maps.cache.line_bytes);
}

/// What records the run anew, with a setting changed.
std::string Retimer::command_again(const std::pair<std::string, std::string>& changed, const std::string& more) const {
  const bool has_file = !trace_.inputs.empty();
  std::string command = "bumpsim run " + (has_file ? "SCENE" : trace_.scene) + " --scheme " + trace_.scheme;
  for (const auto& [key, entry] : recorded_.entries())
    if (key != changed.first && !(entry.value == recorded_.parameters().find(key)->fallback))
      command += " --set " + key + "=" + to_string(entry.value);
  if (!changed.first.empty()) command += " --set " + changed.first + "=" + changed.second;
  command += " --record FILE" + more;
  return has_file ? command + ", where SCENE was '" + trace_.inputs.front().path + "'" : command;
}

bool Retimer::is_fetch_key(const std::string& key) const {
  return std::find(fetch_keys_.begin(), fetch_keys_.end(), key) != fetch_keys_.end();
}

bool Retimer::is_unused(const std::string& key) const {
  const std::vector<std::string> keys = LightMapFetchConfig::look_up_keys();
  return light_maps() == nullptr && std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool Retimer::fetches_anew(const Configuration& configuration) const {
  return std::any_of(fetch_keys_.begin(), fetch_keys_.end(),
                     [&](const std::string& key) { return configuration.entries().at(key).value != recorded_.entries().at(key).value; });
}

FetchSettings Retimer::fetch_settings(const Configuration& configuration) const {
  FetchSettings settings;
  settings.texture = TextureFetchConfig(configuration);
  if (light_maps()) settings.light_maps = LightMapFetchConfig(configuration);
  return settings;
}

std::vector<FetchedTrace> Retimer::fetch(const std::vector<FetchSettings>& settings, const std::atomic<bool>* cancelled) const {
  std::vector<FetchedTrace> fetched = refetch(trace_, light_maps(), settings, cancelled);
  if (cancelled != nullptr && *cancelled) return fetched;
  const FetchSettings before = fetch_settings(recorded_);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!(settings[i] == before)) continue;
    for (const traced::Index stream : {traced::texture, traced::light_map})
      if (!same_stream(fetched[i].trace.streams[stream], trace_.streams[stream]))
        throw Error(ErrorKind::self_check,
                    {"self-check failed: the addresses of the trace give other hits than were recorded", {name_}, "", again});
  }
  return fetched;
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
  std::vector<FetchedTrace> fetched;
  if (trace_.has_addresses()) fetched = fetch({fetch_settings(configuration)}, nullptr);
  Retimed retimed = replay(fetched.empty() ? trace_ : fetched.front().trace, timing, watch);
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
  RetimedRun run{std::move(retimed.timing), bound, std::nullopt};
  if (!fetched.empty()) run.traffic = std::move(fetched.front().traffic);
  return run;
}

}  // namespace bump
