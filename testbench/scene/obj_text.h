#pragma once
// The geometry of a Wavefront OBJ file, read strictly: v, vt, vn, f, usemtl, mtllib; numbers in double precision. Common readers take what
// they can of a damaged line (a missing coordinate becomes 0, a wrong index is dropped); here every such line is an error with its number.
// Left out: curves, surfaces, lines, points, smoothing groups, vertex colours (ignored).

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace bump {

/// Indices from 0 into the lists of ObjText; -1 where the file gives none.
struct ObjCorner {
  int position = 0, texture = -1, normal = -1;
};

struct ObjFace {
  std::vector<ObjCorner> corners;  ///< 3 to 1024, counter-clockwise
  int material = -1;               ///< index into ObjText::materials
  int line = 0;
};

struct ObjText {
  std::vector<glm::dvec3> positions, normals;
  std::vector<glm::dvec2> textures;
  std::vector<ObjFace> faces;
  std::vector<std::string> materials;  ///< names, in order of first use
  struct Library {
    std::string name;
    Location where;
  };
  std::vector<Library> libraries;
};

/// Throws Error(input) with file and line: too few or damaged or non-finite numbers, faces with fewer than three corners or an index out of
/// range, no vertices, no faces, binary content.
ObjText parse_obj(const std::string& text, const std::string& file);

}  // namespace bump
