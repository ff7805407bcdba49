#pragma once
// The part of a Wavefront MTL material library that bump mapping needs: diffuse colour and its map, height or normal map and the height's
// multiplier (-bm). Parsing is tinyobjloader's. Left out: every other coefficient and map.

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

namespace bump {

struct LibraryMaterial {
  glm::dvec3 colour{0.8};  ///< Kd, clamped to [0, 1]; a neutral grey where the library gives none
  std::string colour_map;  ///< map_Kd, as written in the library; "" for none
  std::string bump_map;    ///< map_Bump or bump
  std::string normal_map;  ///< norm
  double bump_multiplier = 1;
};

/// Materials by name. `file` is the name used in warnings: keys that are not known are named in one.
std::map<std::string, LibraryMaterial> parse_material_library(const std::string& text, const std::string& file,
                                                              std::vector<std::string>& warnings);

}  // namespace bump
