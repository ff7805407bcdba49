#include "testbench/scene/mesh_objects.h"

#include <filesystem>
#include <optional>

#include "testbench/scene/material_library.h"
#include "testbench/scene/obj_file.h"
#include "testbench/scene/shapes.h"

namespace bump {

namespace fs = std::filesystem;

namespace {

struct FoundMaterial {
  LibraryMaterial material;
  FileName library;  ///< maps are relative to it
};

bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::map<std::string, FoundMaterial> read_libraries(const ObjModel& model, const FileName& mesh, InputFiles& files,
                                                    std::vector<std::string>& warnings) {
  std::map<std::string, FoundMaterial> found;
  for (const auto& library : model.libraries) {
    const FileName file = file_beside(mesh, library.name);
    if (!is_file(file.path)) {
      const Location where(mesh.shown, library.where.line);
      warnings.push_back(to_string(where) + ": material library '" + file.shown + "' does not exist; its materials are neutral grey");
      continue;
    }
    for (const auto& [name, material] : parse_material_library(files.read(file, "material library", library.where), file, warnings)) {
      found.emplace(name, FoundMaterial{material, file});
    }
  }
  return found;
}

/// The file of a map, none (and a warning) if it is missing.
std::optional<FileName> map_file(const FoundMaterial& found, const std::string& map, const std::string& material,
                                 std::vector<std::string>& warnings) {
  if (map.empty()) return std::nullopt;
  const FileName file = file_beside(found.library, map);
  if (is_file(file.path)) return file;
  warnings.push_back("'" + found.library.shown + "': texture '" + file.shown + "' of material '" + material +
                     "' does not exist; it is left out");
  return std::nullopt;
}

void apply_material(const FoundMaterial& found, const std::string& name, const MeshSurface& given, TextureStore& textures,
                    std::vector<std::string>& warnings, SceneObject& object) {
  const Location from(found.library.path);
  const LibraryMaterial& material = found.material;
  if (!object.colour) {
    const auto map = map_file(found, material.colour_map, name, warnings);
    if (!map) {
      object.colour = std::make_shared<const Texture>(constant_colour(material.colour.r, material.colour.g, material.colour.b));
    } else {
      object.colour = textures.colour(*map, given.wrap, from);
    }
  }
  if (object.normals) return;
  BumpTextures bump;
  if (const auto normals = map_file(found, material.normal_map, name, warnings)) {
    bump = textures.from_normals(*normals, false, given.wrap, from, NamedBy::material_library);
  } else if (const auto map = map_file(found, material.bump_map, name, warnings)) {
    bump = textures.from_either(*map, default_bump_scale * material.bump_multiplier, given.wrap, from);
  }
  object.normals = bump.normals;
  object.heights = bump.heights;
}

void fill_gaps(const MeshSurface& given, SceneObject& object) {
  if (!object.colour) object.colour = std::make_shared<const Texture>(constant_colour(0.8, 0.8, 0.8));
  if (object.normals) return;
  if (given.built_in_relief) {
    object.heights = std::make_shared<const Texture>(stud_heights());
    object.normals = std::make_shared<const Texture>(normals_from_heights(*object.heights));
  } else {
    object.normals = std::make_shared<const Texture>(flat_normals());
  }
}

}  // namespace

std::string suffix_of(const std::string& path) {
  std::string suffix = fs::path(path).extension().string();
  for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return suffix;
}

std::vector<SceneObject> objects_from_mesh(const FileName& file, const Location& from, const std::string& name, const MeshSurface& given,
                                           InputFiles& files, TextureStore& textures, std::vector<std::string>& warnings) {
  const std::string& path = file.path;
  const std::string suffix = suffix_of(path);
  const Location where = from.file.empty() ? Location{path, 0, 0} : from;
  if (suffix == ".gltf" || suffix == ".glb") {
    throw Error({"mesh '" + path + "' is a glTF file", where, "glTF is not supported yet",
                 "export it as Wavefront OBJ (.obj) with its material library"});
  }
  if (suffix != ".obj")
    throw Error({"mesh '" + path + "' is of no known format", where, "meshes are read from Wavefront OBJ files", "export it as .obj"});

  const std::string text = files.read(file, "mesh", from);
  const bool complete = given.colour && given.bump.normals;
  ObjModel model = build_obj(text, file, !complete, warnings);
  std::map<std::string, FoundMaterial> materials;
  if (!complete) materials = read_libraries(model, file, files, warnings);

  std::vector<SceneObject> objects;
  for (MeshPart& part : model.parts) {
    SceneObject object;
    object.name = model.parts.size() == 1 || part.material.empty() ? name : name + "/" + part.material;
    if (given.u_scale != 1 || given.v_scale != 1) scale_texture(part.mesh, given.u_scale, given.v_scale);
    object.mesh = std::make_shared<const Mesh>(std::move(part.mesh));
    object.colour = given.colour;
    object.normals = given.bump.normals;
    object.heights = given.bump.heights;
    const auto found = materials.find(part.material);
    if (found != materials.end()) {
      apply_material(found->second, part.material, given, textures, warnings, object);
    } else if (!complete && !part.material.empty() && !model.libraries.empty() && !materials.empty()) {
      warnings.push_back("'" + file.shown + "': no library describes material '" + part.material + "'; it is neutral grey");
    }
    fill_gaps(given, object);
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace bump
