#include "testbench/experiments/sweep_plan.h"

#include <algorithm>
#include <map>
#include <set>

#include "datapath/sha256.h"
#include "testbench/experiments/sweep_columns.h"
#include "testbench/results/result_json.h"
#include "testbench/scene/scene_file.h"
#include "units/light_map_fetch.h"
#include "units/texture_fetch.h"

namespace bump {

namespace {

constexpr std::size_t digits_of_id = 20;

std::string hash_of(const std::string& text) {
  return sha256_hex(text.data(), text.size());
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + "\n";
  return text;
}

/// What does not vary between points: versions, columns, and what every parameter is unless it is set.
std::string common_part(const Parameters& parameters, const std::string& version, bool quality) {
  std::string text = "bumpsim-sweep " + std::to_string(sweep_schema_version) + " " + std::to_string(result_schema_version) + "\n" +
                     version + "\n" + joined(sweep_columns()) + (quality ? "measured\n" : "not measured\n");
  for (const auto& [key, parameter] : parameters.all()) text += key + "=" + to_string(parameter.fallback) + "\n";
  return hash_of(text);
}

}  // namespace

bool is_cache_parameter(const Parameter& parameter) {
  const auto named_in = [&](const std::vector<std::string>& keys) {
    return std::find(keys.begin(), keys.end(), parameter.key) != keys.end();
  };
  return named_in(TextureFetchConfig::look_up_keys()) || named_in(LightMapFetchConfig::look_up_keys());
}

bool is_dated_again(const Parameter& parameter) {
  return parameter.timing_only || is_cache_parameter(parameter);
}

SweepPlan::SweepPlan(SweepSpec spec, const std::string& version) : spec_(std::move(spec)) {
  const Parameters& parameters = spec_.base.parameters();
  prefix_ = common_part(parameters, version, spec_.quality);
  for (const SweptScene& scene : spec_.scenes) scenes_.push_back(read_scene(scene.path));
  std::vector<bool> varies_values;  // by swept key
  for (const std::string& key : spec_.keys) varies_values.push_back(!is_dated_again(*parameters.find(key)));

  std::set<std::string> ids;
  std::map<std::string, std::size_t> groups;
  Configuration configuration = spec_.base;
  std::string all = joined(spec_.keys);
  for (const SpecPoint& point : spec_.points) {
    const Scene& scene = sized_scene(point);
    for (std::size_t i = 0; i < spec_.keys.size(); ++i) configuration.set(spec_.keys[i], point.values[i], {spec_.file});
    const std::string id = id_of(point, scene, configuration);
    if (!ids.insert(id).second) {
      ++repeated_;
      continue;
    }
    std::string group = spec_.scenes[point.scene].name + "\n" + std::to_string(scene.width) + "x" + std::to_string(scene.height) + "\n" +
                        std::to_string(point.scheme);
    for (std::size_t i = 0; i < spec_.keys.size(); ++i)
      if (varies_values[i]) group += "\n" + to_string(point.values[i]);
    const auto [place, added] = groups.emplace(group, groups_.size());
    if (added) groups_.push_back({&scene, spec_.schemes[point.scheme], {}, false});
    groups_[place->second].members.push_back(points_.size());
    all += id + " " + spec_.scenes[point.scene].name + "\n";
    points_.push_back({point, id, place->second});
  }
  spec_.points = {};
  id_ = hash_of(all);

  for (std::size_t i = 0; i < spec_.keys.size(); ++i) {
    if (!is_cache_parameter(*parameters.find(spec_.keys[i]))) continue;
    for (const PlannedPoint& point : points_) {
      PointGroup& group = groups_[point.group];
      if (!(points_[group.members.front()].spec.values[i] == point.spec.values[i])) group.varies_caches = true;
    }
  }
}

const Scene& SweepPlan::sized_scene(const SpecPoint& point) {
  const Scene& scene = scenes_[point.scene];
  const int width = point.width > 0 ? point.width : scene.width, height = point.height > 0 ? point.height : scene.height;
  if (width == scene.width && height == scene.height) return scene;
  for (const Scene& known : sized_)
    if (known.objects.front().mesh == scene.objects.front().mesh && known.name == scene.name && known.width == width &&
        known.height == height)
      return known;
  sized_.push_back(scene);
  sized_.back().width = width;
  sized_.back().height = height;
  return sized_.back();
}

std::string SweepPlan::id_of(const SpecPoint& point, const Scene& scene, const Configuration& configuration) const {
  std::string text = prefix_ + "\n" + spec_.schemes[point.scheme]->page().id + "\n" + std::to_string(scene.width) + "x" +
                     std::to_string(scene.height) + "\n";
  for (const Scene::InputFile& input : scene.inputs) text += input.path + " " + input.sha256 + "\n";
  const Scheme& scheme = *spec_.schemes[point.scheme];
  for (const auto& [key, entry] : configuration.entries()) {
    const ParameterValue& fallback = configuration.parameters().find(key)->fallback;
    if (!(entry.value == fallback) && concerns(key, scheme)) text += key + "=" + to_string(entry.value) + "\n";
  }
  return hash_of(text).substr(0, digits_of_id);
}

void SweepPlan::apply(std::size_t point, Configuration& configuration) const {
  const std::vector<ParameterValue>& values = points_[point].spec.values;
  for (std::size_t i = 0; i < values.size(); ++i) configuration.set(spec_.keys[i], values[i], {spec_.file});
}

Configuration SweepPlan::configuration_of(std::size_t point) const {
  Configuration configuration = spec_.base;
  apply(point, configuration);
  return configuration;
}

Configuration SweepPlan::recorded_configuration(const PointGroup& group) const {
  Configuration configuration = configuration_of(group.members.front());
  for (const auto& [key, parameter] : configuration.parameters().all())
    if (parameter.timing_only || (group.varies_caches && is_cache_parameter(parameter)))
      configuration.set(key, parameter.fallback, {"default"});
  return configuration;
}

std::string SweepPlan::describe(std::size_t point) const {
  const PointGroup& group = group_of(point);
  std::string text =
      "point " + std::to_string(point) + " (" + group.scheme->page().id + " on " + spec_.scenes[points_[point].spec.scene].name;
  for (std::size_t i = 0; i < spec_.keys.size(); ++i)
    if (concerns(spec_.keys[i], *group.scheme)) text += ", " + spec_.keys[i] + " = " + to_string(points_[point].spec.values[i]);
  return text + ")";
}

bool SweepPlan::is_in(const Shard& shard, std::size_t point) const {
  const std::size_t of = static_cast<std::size_t>(shard.of), mine = static_cast<std::size_t>(shard.index) - 1;
  return (groups_.size() >= of ? points_[point].group : point) % of == mine;
}

}  // namespace bump
