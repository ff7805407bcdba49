#include "testbench/experiments/sweep_spec.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "testbench/experiments/sweep_sections.h"
#include "testbench/scene/config_file.h"
#include "testbench/scene/input_files.h"
#include "testbench/scene/scene_names.h"
#include "testbench/scene/strict_table.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

bool is_section(const std::string& key) {
  return key == "grid" || key == "list" || key == "random" || key == "one_at_a_time";
}

std::string beside(const std::string& file, const std::string& path) {
  return fs::path(path).is_absolute() ? path : (fs::path(file).parent_path() / path).lexically_normal().string();
}

class SpecReader {
 public:
  SpecReader(const std::string& path, const Parameters& parameters, const std::vector<std::string>& scene_folders)
      : scene_folders_(scene_folders), keys_(parameters), spec_{path, {}, {}, Configuration(parameters), true, {}, {}} {}

  SweepSpec read() {
    const TomlValue document = parse_toml(read_bytes(spec_.file, "sweep"), spec_.file);
    const StrictTable root(document, "the sweep",
                           {"scenes", "schemes", "quality", "config", "base", "grid", "list", "random", "one_at_a_time"});
    read_quality(root);
    if (const TomlEntry* scenes = document.find("scenes")) {
      common_scenes_ = keys_.values({scene_key, scenes->where, &scenes->value});
      for (std::size_t i = 0; i < common_scenes_.size(); ++i)
        index_of_scene(std::get<std::string>(common_scenes_[i]),
                       scenes->value.items.empty() ? scenes->value.where : scenes->value.items[i].where);
    }
    if (const TomlEntry* schemes = document.find("schemes")) common_schemes_ = keys_.values({scheme_key, schemes->where, &schemes->value});
    if (const TomlValue* files = root.find("config")) read_files(*files);
    if (const TomlEntry* base = document.find("base")) read_base(*base);

    bool has_sections = false;
    for (const TomlEntry& entry : document.entries) {
      if (!is_section(entry.key)) continue;
      has_sections = true;
      read_section(entry);
    }
    if (!has_sections) add_points({{}}, document.where);
    refuse_idle_keys(Location(spec_.file));
    finish();
    return std::move(spec_);
  }

 private:
  void read_quality(const StrictTable& root) {
    const TomlValue* quality = root.find("quality");
    if (quality == nullptr) return;
    if (quality->kind != TomlValue::Kind::boolean)
      root.reject("quality", "is " + kind_name(quality->kind), "it says whether pictures are measured", "quality = false");
    spec_.quality = quality->boolean;
  }

  void read_files(const TomlValue& files) {
    const std::vector<TomlValue> one = {files};
    for (const TomlValue& file : files.kind == TomlValue::Kind::array ? files.items : one) {
      if (file.kind != TomlValue::Kind::text)
        throw Error({"config is " + kind_name(file.kind), file.where, "it names configuration files", "config = [\"slow_memory.toml\"]"});
      const std::string path = beside(spec_.file, file.text);
      read_configuration_text(read_bytes(path, "configuration", file.where, true), path, spec_.base);
    }
  }

  void read_base(const TomlEntry& base) {
    if (base.value.kind != TomlValue::Kind::table)
      throw Error({"base is " + kind_name(base.value.kind), base.value.where, "it holds settings of all points", "[base]"});
    for (const SweepKeys::Leaf& leaf : keys_.leaves(base.value, {}, false)) {
      if (leaf.key == scene_key || leaf.key == scheme_key)
        throw Error({leaf.key + " is no setting of the base", leaf.where, "", leaf.key + "s = [...], in front of all tables"});
      const ParameterValue value = keys_.value(leaf, *leaf.value);
      if (leaf.key == width_key)
        base_width_ = static_cast<int>(std::get<std::int64_t>(value));
      else if (leaf.key == height_key)
        base_height_ = static_cast<int>(std::get<std::int64_t>(value));
      else
        spec_.base.set(leaf.key, value, leaf.value->where);
    }
  }

  void read_section(const TomlEntry& section) {
    const bool several = section.value.kind == TomlValue::Kind::array;
    const std::vector<TomlValue> one = {section.value};
    std::vector<Assignments> listed;
    for (const TomlValue& table : several ? section.value.items : one) {
      if (table.kind != TomlValue::Kind::table)
        throw Error({section.key + " is " + kind_name(several ? TomlValue::Kind::array : table.kind), table.where,
                     "it is a table of parameters", several ? "[[" + section.key + "]]" : "[" + section.key + "]"});
      std::vector<Assignments> points = section_points(section.key, {section.key, section.where, table}, keys_);
      if (section.key == "list")
        listed.push_back(std::move(points.front()));
      else
        add_points(points, table.where);
    }
    if (!listed.empty()) add_points(listed, section.where);
  }

  std::size_t index_of_scene(const std::string& name, const Location& where) {
    const auto known = std::find_if(spec_.scenes.begin(), spec_.scenes.end(), [&](const SweptScene& scene) { return scene.name == name; });
    if (known != spec_.scenes.end()) return static_cast<std::size_t>(known - spec_.scenes.begin());
    const bool is_name = fs::path(name).filename().string() == name && fs::path(name).extension().empty();
    try {
      spec_.scenes.push_back({name, find_scene_path(is_name ? name : beside(spec_.file, name), scene_folders_)});
    } catch (const Error& error) {
      ErrorText text = error.text();
      text.where = where;
      throw Error(text);
    }
    return spec_.scenes.size() - 1;
  }

  std::size_t index_of_scheme(const std::string& id) {
    const Scheme* scheme = &find_scheme(id);
    const auto known = std::find(spec_.schemes.begin(), spec_.schemes.end(), scheme);
    if (known != spec_.schemes.end()) return static_cast<std::size_t>(known - spec_.schemes.begin());
    spec_.schemes.push_back(scheme);
    return spec_.schemes.size() - 1;
  }

  std::size_t index_of_key(const std::string& key) {
    const auto [place, added] = key_index_.emplace(key, spec_.keys.size());
    if (added) spec_.keys.push_back(key);
    return place->second;
  }

  /// Every point for every scene and scheme, unless it names its own: then once.
  void add_points(const std::vector<Assignments>& points, const Location& where) {
    const auto own = [](const Assignments& point, const char* key) -> const ParameterValue* {
      const auto found = std::find_if(point.begin(), point.end(), [&](const Assignment& assignment) { return assignment.key == key; });
      return found == point.end() ? nullptr : &found->value;
    };
    const auto named = [&](const ParameterValue* value, const char* what, const char* example) {
      if (value != nullptr) return std::get<std::string>(*value);
      const std::string list = std::string(what) + "s";
      throw Error({"the sweep names no " + list, where, "", list + " = [\"" + example + "\"], in front of all tables"});
    };
    // Scenes and schemes vary slowest: what is drawn and recorded once is used at once.
    for (std::size_t i = 0; i < std::max<std::size_t>(1, common_scenes_.size()); ++i)
      for (std::size_t j = 0; j < std::max<std::size_t>(1, common_schemes_.size()); ++j)
        for (const Assignments& point : points) {
          const ParameterValue *scene = own(point, scene_key), *scheme = own(point, scheme_key);
          if ((scene != nullptr && i > 0) || (scheme != nullptr && j > 0)) continue;
          if (scene == nullptr && i < common_scenes_.size()) scene = &common_scenes_[i];
          if (scheme == nullptr && j < common_schemes_.size()) scheme = &common_schemes_[j];
          add_point(point, named(scene, scene_key, "world_sphere"), named(scheme, scheme_key, "lee2007"), where);
        }
  }

  void add_point(const Assignments& point, const std::string& scene, const std::string& scheme, const Location& where) {
    if (spec_.points.size() >= most_sweep_points) refuse_size(where);
    SpecPoint added{index_of_scene(scene, where), index_of_scheme(scheme), base_width_, base_height_, {}};
    std::vector<std::pair<std::size_t, ParameterValue>> set;
    for (const Assignment& assignment : point) {
      if (assignment.key == scene_key || assignment.key == scheme_key) continue;
      if (assignment.key == width_key)
        added.width = static_cast<int>(std::get<std::int64_t>(assignment.value));
      else if (assignment.key == height_key)
        added.height = static_cast<int>(std::get<std::int64_t>(assignment.value));
      else
        add_setting(assignment, *spec_.schemes[added.scheme], set);
    }
    spec_.points.push_back(std::move(added));
    settings_.push_back(std::move(set));
  }

  /// What another scheme alone declares is no setting of this point.
  void add_setting(const Assignment& assignment, const Scheme& scheme, std::vector<std::pair<std::size_t, ParameterValue>>& set) {
    const std::size_t key = index_of_key(assignment.key);
    if (!concerns(assignment.key, scheme)) return;
    set.emplace_back(key, assignment.value);
    used_keys_.insert(key);
  }

  void refuse_idle_keys(const Location& where) const {
    for (std::size_t i = 0; i < spec_.keys.size(); ++i)
      if (used_keys_.count(i) == 0)
        throw Error({"no point of the sweep has a scheme with the parameter " + spec_.keys[i], where, "only that scheme reads it",
                     "schemes = [..., \"" + spec_.keys[i].substr(0, spec_.keys[i].find('.')) + "\"]"});
  }

  /// What a point leaves open is the base's.
  void finish() {
    std::vector<ParameterValue> base;
    for (const std::string& key : spec_.keys) base.push_back(spec_.base.entries().at(key).value);
    for (std::size_t i = 0; i < spec_.points.size(); ++i) {
      spec_.points[i].values = base;
      for (const auto& [key, value] : settings_[i]) spec_.points[i].values[key] = value;
    }
  }

  const std::vector<std::string>& scene_folders_;
  SweepKeys keys_;
  SweepSpec spec_;
  std::vector<ParameterValue> common_scenes_, common_schemes_;
  int base_width_ = 0, base_height_ = 0;
  std::map<std::string, std::size_t> key_index_;
  std::set<std::size_t> used_keys_;                                            ///< by some point whose scheme has them
  std::vector<std::vector<std::pair<std::size_t, ParameterValue>>> settings_;  ///< of each point, by key
};

}  // namespace

bool concerns(const std::string& key, const Scheme& scheme) {
  const std::string module = key.substr(0, key.find('.'));
  if (module == scheme.page().id) return true;
  const std::vector<const Scheme*> all = all_schemes();
  return std::none_of(all.begin(), all.end(), [&](const Scheme* other) { return other->page().id == module; });
}

SweepSpec read_sweep_spec(const std::string& path, const Parameters& parameters, const std::vector<std::string>& scene_folders) {
  return SpecReader(path, parameters, scene_folders).read();
}

}  // namespace bump
