// `bumpsim check`: reads a file as a run would, and says what it holds or what is wrong with it.

#include <fmt/core.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/scene/config_file.h"
#include "testbench/scene/input_files.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"
#include "testbench/scene/toml_document.h"

namespace bump {

namespace {

using Json = nlohmann::ordered_json;

/// Scene files and configuration files are both TOML; only scenes have any of these tables.
bool is_scene(const std::string& path) {
  const TomlValue document = parse_toml(read_bytes(path, "file"), path);
  for (const char* key : {"frame", "camera", "light", "object"})
    if (document.find(key) != nullptr) return true;
  return false;
}

Json describe(const Scene& scene) {
  Json document = {{"kind", "scene"}, {"name", scene.name}, {"width", scene.width}, {"height", scene.height}, {"lights", scene.lights.size()}};
  document["objects"] = Json::array();
  for (const SceneObject& object : scene.objects)
    document["objects"].push_back({{"name", object.name}, {"vertices", object.mesh->vertices.size()}, {"triangles", object.mesh->triangles.size()}});
  for (const Scene::InputFile& input : scene.inputs) document["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
  document["warnings"] = scene.warnings;
  return document;
}

int check_scene(const std::string& path, bool json) {
  const Scene scene = read_scene(path);
  const Json document = describe(scene);
  if (json) {
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("{}: a scene of {} x {} pixels, {} light{}\n", path, scene.width, scene.height, scene.lights.size(), scene.lights.size() == 1 ? "" : "s");
  for (const SceneObject& object : scene.objects)
    fmt::print("  object {}: {} vertices, {} triangles\n", object.name, object.mesh->vertices.size(), object.mesh->triangles.size());
  for (const std::string& warning : scene.warnings) fmt::print("  warning: {}\n", warning);
  fmt::print("ok\n");
  return 0;
}

int check_configuration(const std::string& path, bool json) {
  const Configuration configuration = configure({path}, {});
  Json document = {{"kind", "configuration"}, {"settings", Json::object()}};
  for (const auto& [key, entry] : configuration.entries())
    if (entry.origin.file == path) document["settings"][key] = to_string(entry.value);
  if (json) {
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("{}: a configuration that sets {} parameters\n", path, document["settings"].size());
  for (const auto& [key, value] : document["settings"].items()) fmt::print("  {} = {}\n", key, value.get<std::string>());
  fmt::print("ok\n");
  return 0;
}

}  // namespace

int check_command(const CheckArguments& arguments) {
  const std::string path = scene_path(arguments.file);
  const bool toml = std::filesystem::path(path).extension() == ".toml";
  if (toml && !is_scene(path)) return check_configuration(path, arguments.json);
  return check_scene(path, arguments.json);
}

}  // namespace bump
