#include "testbench/scene/scene_file.h"

#include <cmath>
#include <filesystem>

#include "testbench/scene/input_files.h"
#include "testbench/scene/mesh_objects.h"
#include "testbench/scene/object_reader.h"
#include "testbench/scene/strict_table.h"

namespace bump {

namespace {

constexpr std::size_t most_lights = 8;
constexpr double pi = 3.14159265358979323846;

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

void read_scene_file(const std::string& path, InputFiles& files, TextureStore& textures, Scene& scene) {
  const TomlValue document = parse_toml(files.read(path, "scene"), path);
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
  for (const auto& object : tables_of(root, "object", path)) read_object(object, path, files, textures, scene);
}

/// Camera and light for a bare mesh: the camera in front (+z), a little to the right and above, so that the bounding sphere fills the
/// frame; the light about 50 degrees to its left, so that relief shows.
void place_by_bounds(Scene& scene) {
  glm::dvec3 low(scene.objects[0].mesh->vertices[0].position), high = low;
  for (const auto& object : scene.objects) {
    for (const auto& vertex : object.mesh->vertices) {
      low = glm::min(low, vertex.position);
      high = glm::max(high, vertex.position);
    }
  }
  scene.camera.target = 0.5 * (low + high);
  double radius = 0;
  for (const auto& object : scene.objects) {
    for (const auto& vertex : object.mesh->vertices) radius = std::max(radius, glm::distance(vertex.position, scene.camera.target));
  }
  scene.camera.field_of_view = 35;
  const double distance = radius / std::sin(0.5 * scene.camera.field_of_view * pi / 180);
  scene.camera.eye = scene.camera.target + distance * glm::normalize(glm::dvec3(0.35, 0.3, 1));
  scene.camera.up = glm::dvec3(0, 1, 0);
  scene.camera.near = 0.01 * radius;
  Light light;
  light.vector = glm::normalize(glm::dvec3(-0.5, 0.7, 0.75));
  scene.lights = {light};
}

}  // namespace

Scene read_scene(const std::string& path) {
  Scene scene;
  scene.name = std::filesystem::path(path).stem().string();
  InputFiles files;
  TextureStore textures(files, scene.warnings);
  const std::string suffix = suffix_of(path);
  if (suffix == ".obj" || suffix == ".gltf" || suffix == ".glb") {
    MeshSurface surface;
    surface.built_in_relief = true;
    scene.objects = objects_from_mesh(path, {}, scene.name, surface, files, textures, scene.warnings);
    place_by_bounds(scene);
  } else {
    if (suffix != ".toml") {
      read_bytes(path, "scene");  // a file that is not there is the nearer problem
      throw Error({"'" + path + "' is no scene", {path, 0, 0}, "a scene is a .toml file or an .obj mesh", ""});
    }
    read_scene_file(path, files, textures, scene);
  }
  scene.inputs = files.list();
  // Named from the scene's folder, so that a result does not depend on where the program was called.
  const std::filesystem::path folder = std::filesystem::path(path).parent_path().lexically_normal();
  for (auto& input : scene.inputs) {
    const auto relative = std::filesystem::path(input.path).lexically_normal().lexically_relative(folder.empty() ? "." : folder);
    if (!relative.empty()) input.path = relative.generic_string();
  }
  return scene;
}

}  // namespace bump
