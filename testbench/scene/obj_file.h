#pragma once
// Turns the text of a Wavefront OBJ file into meshes ready for bump mapping: polygons cut into triangles, missing normals, texture
// coordinates and tangents made up as mesh_frames.h says. Whatever is mended is told in a warning that names the file and how much.

#include <string>
#include <vector>

#include "testbench/scene/file_name.h"
#include "testbench/scene/obj_text.h"
#include "units/scene.h"

namespace bump {

struct MeshPart {
  std::string material;  ///< name in the file's material library, "" for none
  Mesh mesh;
};

struct ObjModel {
  std::vector<MeshPart> parts;  ///< one for each material in use, at least one
  std::vector<ObjText::Library> libraries;
};

/// `text` is the content of `file`. `split`: one part for each material, otherwise one part in all. Throws Error(input): see parse_obj(),
/// and if no triangle has any area. Warns about dropped triangles without area, triangles turned round because their normals say so,
/// normals without length, and texture coordinates that had to be projected.
ObjModel build_obj(const std::string& text, const FileName& file, bool split, std::vector<std::string>& warnings);

/// Reads `path` as one mesh; otherwise like build_obj().
Mesh load_obj(const std::string& path, std::vector<std::string>& warnings);

}  // namespace bump
