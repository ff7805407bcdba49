#include "testbench/scene/material_library.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <sstream>

#include "testbench/scene/material_text.h"

namespace bump {

std::map<std::string, LibraryMaterial> parse_material_library(const std::string& text, const FileName& file,
                                                              std::vector<std::string>& warnings) {
  std::map<std::string, int> index_of;
  std::vector<tinyobj::material_t> parsed;
  std::string remarks, errors;
  // A NUL would end a line early for the parser and not for us.
  std::string clean = text;
  std::replace(clean.begin(), clean.end(), '\0', ' ');
  std::istringstream stream(used_material_text(clean, file, warnings));
  tinyobj::LoadMtl(&index_of, &parsed, &stream, &remarks, &errors);

  std::map<std::string, LibraryMaterial> materials;
  for (const auto& source : parsed) {
    if (source.name.empty()) continue;  // the parser's own default
    LibraryMaterial material;
    const glm::dvec3 diffuse(source.diffuse[0], source.diffuse[1], source.diffuse[2]);
    if (diffuse != glm::dvec3(0)) material.colour = glm::clamp(diffuse, 0.0, 1.0);
    material.colour_map = source.diffuse_texname;
    material.bump_map = source.bump_texname;
    material.normal_map = source.normal_texname;
    material.bump_multiplier = source.bump_texopt.bump_multiplier;
    materials[source.name] = material;
  }
  return materials;
}

}  // namespace bump
