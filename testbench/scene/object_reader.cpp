#include "testbench/scene/object_reader.h"

#include <algorithm>
#include <cmath>

#include "testbench/scene/mesh_objects.h"
#include "testbench/scene/shapes.h"
#include "testbench/scene/strict_table.h"

namespace bump {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Shapes and the keys that belong to one or some of them only.
struct ShapeKeys {
  const char* shape;
  std::vector<std::string> keys;
};

const std::vector<ShapeKeys>& shapes() {
  static const std::vector<ShapeKeys> list = {{"plane", {"size", "tessellation"}},
                                              {"cube", {"size", "tessellation"}},
                                              {"sphere", {"radius", "tessellation"}},
                                              {"torus", {"radius", "tube", "tessellation"}},
                                              {"mesh", {"mesh"}}};
  return list;
}

std::string read_shape(const StrictTable& table) {
  std::vector<std::string> words;
  for (const auto& known : shapes()) words.emplace_back(known.shape);
  if (!table.has("shape")) {
    table.reject("shape", "is missing", "an object is one of plane, cube, sphere, torus, mesh", "shape = \"sphere\"");
  }
  const std::string shape = table.word("shape", words);
  const auto own = std::find_if(shapes().begin(), shapes().end(), [&](const auto& known) { return known.shape == shape; });
  for (const auto& other : shapes()) {
    for (const auto& key : other.keys) {
      if (!table.has(key) || std::find(own->keys.begin(), own->keys.end(), key) != own->keys.end()) continue;
      std::string list;
      for (const auto& word : own->keys) list += (list.empty() ? "" : ", ") + word;
      table.reject(key, "means nothing for a " + shape, "a " + shape + " has " + list, "leave it out");
    }
  }
  return shape;
}

Mesh make_shape(const StrictTable& table, const std::string& shape) {
  constexpr double smallest = 1e-6, largest = 1e6;
  if (shape == "plane") {
    const auto size = table.pair("size", {2, 2}, smallest, largest);
    const auto cells = table.integer_pair("tessellation", {16, 16}, 1, 1024);
    return make_plane(size.first, size.second, cells.first, cells.second);
  }
  if (shape == "cube") {
    const double size = table.number("size", 2, smallest, largest);
    return make_cube(size, table.integer("tessellation", 8, 1, 512));
  }
  const double radius = table.number("radius", 1, smallest, largest);
  const auto cells = table.integer_pair("tessellation", {64, 32}, 3, 1024);
  if (shape == "sphere") return make_sphere(radius, cells.first, cells.second);
  const double tube = table.number("tube", 0.4 * radius, smallest, largest);
  if (tube >= radius)
    table.reject("tube", "is not smaller than the radius", "the torus would pass through itself", "tube = 0.4 times the radius");
  return make_torus(radius, tube, cells.first, cells.second);
}

/// Rotation about one axis; multiples of a quarter turn are exact.
glm::dmat3 rotation(int axis, double degrees) {
  const double quarters = degrees / 90;
  double cosine = std::cos(degrees * pi / 180), sine = std::sin(degrees * pi / 180);
  if (quarters == std::floor(quarters)) {
    static constexpr double cosines[] = {1, 0, -1, 0};
    const int quarter = static_cast<int>(quarters - 4 * std::floor(quarters / 4));
    cosine = cosines[quarter];
    sine = cosines[(quarter + 3) % 4];
  }
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  glm::dmat3 matrix(1);
  matrix[a][a] = cosine;
  matrix[a][b] = sine;
  matrix[b][a] = -sine;
  matrix[b][b] = cosine;
  return matrix;
}

glm::dmat4 read_placement(const StrictTable& table) {
  const glm::dvec3 degrees = table.vector("rotate", glm::dvec3(0), -36000, 36000);
  const double scale = table.number("scale", 1, 1e-6, 1e6);
  const glm::dmat3 turned = rotation(2, degrees.z) * rotation(1, degrees.y) * rotation(0, degrees.x);
  glm::dmat4 to_world(scale * turned);
  to_world[3] = glm::dvec4(table.vector("translate", glm::dvec3(0)), 1);
  return to_world;
}

Material read_material(const StrictTable& table) {
  Material material;
  const TomlValue* value = table.find("material");
  if (value == nullptr) return material;
  const StrictTable own(*value, "material", {"ambient", "diffuse", "specular", "shininess"});
  material.ambient = own.number("ambient", material.ambient, 0, 10);
  material.diffuse = own.number("diffuse", material.diffuse, 0, 10);
  material.specular = own.number("specular", material.specular, 0, 10);
  material.shininess = own.number("shininess", material.shininess, 1, 1024);
  return material;
}

Wrap read_wrap(const StrictTable& table, const std::string& shape) {
  // Around a sphere the map repeats; over the poles nothing follows.
  const auto words = table.word_pair("wrap", {"repeat", shape == "sphere" ? "clamp" : "repeat"}, {"repeat", "clamp"});
  const auto mode = [](const std::string& word) { return word == "repeat" ? WrapMode::repeat : WrapMode::clamp; };
  return {mode(words.first), mode(words.second)};
}

std::shared_ptr<const Texture> read_colour(const StrictTable& table, const FileName& scene_file, const Wrap& wrap, TextureStore& textures) {
  const TomlValue* value = table.find("colour");
  if (value == nullptr) return nullptr;
  if (value->kind == TomlValue::Kind::array) {
    const glm::dvec3 colour = table.vector("colour", 0, 1);
    return std::make_shared<const Texture>(constant_colour(colour.r, colour.g, colour.b));
  }
  if (value->kind != TomlValue::Kind::text)
    table.reject("colour", "cannot be " + kind_name(value->kind), "it is a picture or [red, green, blue]", "colour = [0.8, 0.8, 0.8]");
  return textures.colour(file_beside(scene_file, table.text("colour")), wrap, table.where("colour"));
}

BumpTextures read_bump(const StrictTable& table, const FileName& scene_file, const Wrap& wrap, TextureStore& textures) {
  const bool has_normals = table.has("normal"), has_heights = table.has("height");
  if (table.has("green") && !has_normals)
    table.reject("green", "means nothing without a normal map", "it says where the map's green channel points", "normal = \"...\"");
  if (table.has("bump_scale") && (!has_heights || has_normals)) {
    table.reject("bump_scale", has_normals ? "means nothing beside a normal map" : "means nothing without a height map",
                 "it is the height of 1.0 in texels", has_normals ? "leave out one of them" : "height = \"...\"");
  }
  if (has_normals) {
    const bool green_down = table.word("green", {"up", "down"}) == "down";
    BumpTextures bump = textures.from_normals(file_beside(scene_file, table.text("normal")), green_down, wrap, table.where("normal"));
    if (has_heights) textures.compare(*bump.normals, file_beside(scene_file, table.text("height")), table.where("height"));
    return bump;
  }
  if (!has_heights) return {};
  const double scale = table.number("bump_scale", default_bump_scale, -1000, 1000);
  return textures.from_heights(file_beside(scene_file, table.text("height")), scale, wrap, table.where("height"));
}

}  // namespace

void read_object(const TomlValue& value, const FileName& scene_file, InputFiles& files, TextureStore& textures, Scene& scene) {
  const StrictTable table(value, "object",
                          {"name", "shape", "mesh", "size", "radius", "tube", "tessellation", "translate", "rotate", "scale", "colour",
                           "height", "bump_scale", "normal", "green", "wrap", "uv_scale", "material"});
  const std::string shape = read_shape(table);
  const std::string name = table.has("name") ? table.text("name") : shape + std::to_string(scene.objects.size() + 1);
  const bool taken = std::any_of(scene.objects.begin(), scene.objects.end(), [&](const auto& object) { return object.name == name; });
  if (taken) table.reject("name", "'" + name + "' is taken", "another object is called so", "name = \"" + name + "_2\"");

  const auto uv_scale = table.pair("uv_scale", {1, 1}, -1000, 1000);
  if (uv_scale.first == 0 || uv_scale.second == 0)
    table.reject("uv_scale", "must not be 0", "the texture would have no extent", "uv_scale = 1.0");
  MeshSurface surface;
  surface.wrap = read_wrap(table, shape);
  surface.u_scale = uv_scale.first;
  surface.v_scale = uv_scale.second;
  const glm::dmat4 to_world = read_placement(table);
  const Material material = read_material(table);
  if (shape == "mesh" && !table.has("mesh")) table.reject("mesh", "is missing", "a mesh is read from a file", "mesh = \"name.obj\"");
  surface.colour = read_colour(table, scene_file, surface.wrap, textures);
  surface.bump = read_bump(table, scene_file, surface.wrap, textures);

  std::vector<SceneObject> objects;
  if (shape == "mesh") {
    objects =
        objects_from_mesh(file_beside(scene_file, table.text("mesh")), table.where("mesh"), name, surface, files, textures, scene.warnings);
  } else {
    Mesh mesh = make_shape(table, shape);
    if (surface.u_scale != 1 || surface.v_scale != 1) scale_texture(mesh, surface.u_scale, surface.v_scale);
    SceneObject object;
    object.name = name;
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.colour = surface.colour ? surface.colour : std::make_shared<const Texture>(constant_colour(0.8, 0.8, 0.8));
    object.normals = surface.bump.normals ? surface.bump.normals : std::make_shared<const Texture>(flat_normals());
    object.heights = surface.bump.heights;
    objects.push_back(std::move(object));
  }
  for (auto& object : objects) {
    object.to_world = to_world;
    object.material = material;
    scene.objects.push_back(std::move(object));
  }
}

}  // namespace bump
