#pragma once
// Scene objects from a mesh file and its material libraries. What the scene gives (colour, bump map) wins; what it leaves open comes from
// the materials, one object for each; what they leave open is neutral grey and, on request, the built-in studs.

#include <memory>
#include <string>
#include <vector>

#include "testbench/scene/input_files.h"
#include "testbench/scene/texture_store.h"
#include "units/scene.h"

namespace bump {

struct MeshSurface {
  std::shared_ptr<const Texture> colour;  ///< null: from the material
  BumpTextures bump;                      ///< without normals: from the material
  Wrap wrap;
  double u_scale = 1, v_scale = 1;
  bool built_in_relief = false;  ///< studs instead of a flat surface where nothing gives a relief
};

/// Height of 1.0 in texels where nothing else is said.
constexpr double default_bump_scale = 2;

/// `file` is an OBJ file; `from` the place that refers to it. Objects are called `name`, or "name/material" if there are several. Throws
/// Error(input): see build_obj(), and for glTF and other mesh formats. Missing libraries and maps are warnings that name them.
std::vector<SceneObject> objects_from_mesh(const FileName& file, const Location& from, const std::string& name, const MeshSurface& given,
                                           InputFiles& files, TextureStore& textures, std::vector<std::string>& warnings);

/// The suffix in lower case, with its dot.
std::string suffix_of(const std::string& path);

}  // namespace bump
