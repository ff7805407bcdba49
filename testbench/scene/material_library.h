#pragma once
// The part of a Wavefront MTL material library that bump mapping needs: diffuse colour and its map, height or normal map and the height's
// multiplier (-bm). Parsing is tinyobjloader's. Left out: every other coefficient and map.

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "testbench/scene/file_name.h"

namespace bump {

struct LibraryMaterial {
  glm::dvec3 colour{0.8};  ///< Kd, clamped to [0, 1]; a neutral grey where the library gives none
  std::string colour_map;  ///< map_Kd, as written in the library; "" for none
  std::string bump_map;    ///< map_Bump or bump
  std::string normal_map;  ///< norm
  double bump_multiplier = 1;
};

/// Materials by name. Throws Error(input) and warns as used_material_text() says.
std::map<std::string, LibraryMaterial> parse_material_library(const std::string& text, const FileName& file,
                                                              std::vector<std::string>& warnings);

}  // namespace bump
