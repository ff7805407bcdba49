#include "testbench/scene/material_library.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace bump {

std::map<std::string, LibraryMaterial> parse_material_library(const std::string& text, const std::string& file,
                                                              std::vector<std::string>& warnings) {
  std::map<std::string, int> index_of;
  std::vector<tinyobj::material_t> parsed;
  std::string remarks, errors;
  // A NUL would end a line early for the parser and not for us.
  std::string clean = text;
  std::replace(clean.begin(), clean.end(), '\0', ' ');
  std::istringstream stream(clean);
  tinyobj::LoadMtl(&index_of, &parsed, &stream, &remarks, &errors);

  std::map<std::string, LibraryMaterial> materials;
  std::set<std::string> unknown;
  for (const auto& source : parsed) {
    if (source.name.empty()) continue;  // the parser's own default
    LibraryMaterial material;
    const glm::dvec3 diffuse(source.diffuse[0], source.diffuse[1], source.diffuse[2]);
    const bool usable = std::isfinite(diffuse.x) && std::isfinite(diffuse.y) && std::isfinite(diffuse.z) && diffuse != glm::dvec3(0);
    if (usable) material.colour = glm::clamp(diffuse, 0.0, 1.0);
    material.colour_map = source.diffuse_texname;
    material.bump_map = source.bump_texname;
    material.normal_map = source.normal_texname;
    const double multiplier = source.bump_texopt.bump_multiplier;
    if (std::isfinite(multiplier) && std::abs(multiplier) <= 1000) {
      material.bump_multiplier = multiplier;
    } else {
      warnings.push_back("'" + file + "': material '" + source.name + "' has an unusable -bm; 1 is used");
    }
    for (const auto& [key, value] : source.unknown_parameter) unknown.insert(key);
    materials[source.name] = material;
  }
  if (!unknown.empty()) {
    std::string list;
    for (const auto& key : unknown) list += (list.empty() ? "" : ", ") + key;
    warnings.push_back("'" + file + "': unknown keys ignored: " + list);
  }
  return materials;
}

}  // namespace bump
