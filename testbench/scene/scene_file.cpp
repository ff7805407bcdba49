#include "testbench/scene/scene_file.h"

#include <cmath>
#include <filesystem>

#include "testbench/scene/input_files.h"
#include "testbench/scene/mesh_objects.h"
#include "testbench/scene/mesh_view.h"
#include "testbench/scene/object_reader.h"
#include "testbench/scene/strict_table.h"

namespace bump {

namespace {

constexpr std::size_t most_lights = 8;

void read_frame(const TomlValue& value, Scene& scene) {
  const StrictTable table(value, "frame", {"width", "height", "background"});
  scene.width = table.integer("width", scene.width, 1, 16384);
  scene.height = table.integer("height", scene.height, 1, 16384);
  scene.background = table.vector("background", scene.background, 0, 1);
}

void read_camera(const TomlValue& value, Camera& camera) {
  const StrictTable table(value, "camera", {"eye", "target", "up", "field_of_view", "near"});
  camera.eye = table.vector("eye");
  camera.target = table.vector("target", camera.target);
  camera.up = table.vector("up", camera.up);
  camera.field_of_view = table.number("field_of_view", camera.field_of_view, 1, 170);
  camera.near = table.number("near", camera.near, 1e-6, 1e6);
  const glm::dvec3 view = camera.target - camera.eye;
  if (glm::length(view) < 1e-9)
    table.reject("eye", "is the same point as the target", "the camera has no direction to look in", "move one of them");
  if (glm::length(camera.up) < 1e-9) table.reject("up", "has no length", "", "up = [0.0, 1.0, 0.0]");
  if (glm::length(glm::cross(glm::normalize(view), glm::normalize(camera.up))) < 1e-6) {
    table.reject("up", "is parallel to the view", "the camera could be turned about it at will",
                 std::abs(glm::normalize(view).z) > 0.9 ? "up = [0.0, 1.0, 0.0]" : "up = [0.0, 0.0, 1.0]");
  }
}

Light read_light(const TomlValue& value) {
  const StrictTable table(value, "light", {"type", "direction", "position", "intensity"});
  Light light;
  light.directional = table.word("type", {"directional", "point"}) == "directional";
  const std::string own = light.directional ? "direction" : "position", other = light.directional ? "position" : "direction";
  if (table.has(other)) {
    table.reject(other, std::string("means nothing for a ") + (light.directional ? "directional" : "point") + " light", "it has a " + own,
                 light.directional ? "type = \"point\"" : "type = \"directional\"");
  }
  light.vector = table.vector(own);
  light.intensity = table.number("intensity", light.intensity, 0, 100);
  if (light.directional) {
    if (glm::length(light.vector) < 1e-9)
      table.reject("direction", "has no length", "it points towards the light", "direction = [0.0, 0.0, 1.0]");
    light.vector = glm::normalize(light.vector);
  }
  return light;
}

/// The tables of a [[name]] list.
const std::vector<TomlValue>& tables_of(const StrictTable& root, const std::string& name, const std::string& file) {
  const TomlValue* list = root.find(name);
  if (list == nullptr || (list->kind == TomlValue::Kind::array && list->items.empty())) {
    throw Error({"the scene has no " + name, {file, 0, 0}, "there would be nothing to see", "[[" + name + "]]"});
  }
  if (list->kind != TomlValue::Kind::array) {
    throw Error({name + " is " + kind_name(list->kind), list->where, "a scene may have several, so that each is an item of a list",
                 "[[" + name + "]]"});
  }
  return list->items;
}

void read_scene_file(const FileName& file, InputFiles& files, TextureStore& textures, Scene& scene) {
  const std::string& path = file.path;
  const TomlValue document = parse_toml(files.read(file, "scene"), path);
  const StrictTable root(document, "the scene", {"frame", "camera", "light", "object"});
  if (const TomlValue* frame = root.find("frame")) read_frame(*frame, scene);
  if (const TomlValue* camera = root.find("camera")) {
    read_camera(*camera, scene.camera);
  } else {
    throw Error({"the scene has no camera", {path, 0, 0}, "", "[camera] with eye and target"});
  }
  const auto& lights = tables_of(root, "light", path);
  if (lights.size() > most_lights) {
    throw Error({"the scene has " + std::to_string(lights.size()) + " lights", lights[most_lights].where, "allowed 1 to 8", "remove some"});
  }
  for (const auto& light : lights) scene.lights.push_back(read_light(light));
  for (const auto& object : tables_of(root, "object", path)) read_object(object, file, files, textures, scene);
}

}  // namespace

Scene read_scene(const std::string& path) {
  Scene scene;
  scene.name = std::filesystem::path(path).stem().string();
  const FileName file = scene_file_name(path);
  InputFiles files;
  TextureStore textures(files, scene.warnings);
  const std::string suffix = suffix_of(path);
  if (suffix == ".obj" || suffix == ".gltf" || suffix == ".glb") {
    MeshSurface surface;
    surface.built_in_relief = true;
    scene.objects = objects_from_mesh(file, {}, scene.name, surface, files, textures, scene.warnings);
    place_view(file.shown, scene);
  } else {
    if (suffix != ".toml") {
      read_bytes(path, "scene");  // a file that is not there is the nearer problem
      throw Error({"'" + path + "' is no scene", {path, 0, 0}, "a scene is a .toml file or an .obj mesh", ""});
    }
    read_scene_file(file, files, textures, scene);
  }
  scene.inputs = files.list();
  return scene;
}

}  // namespace bump
