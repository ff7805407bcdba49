#pragma once
// Where the scenes that come with the program are: $BUMPSIM_SCENES, ./scenes, beside the program, or the source tree it was built from.

#include <string>
#include <vector>

namespace bump {

struct ShippedScene {
  std::string name;   ///< file name without ".toml"
  std::string title;  ///< the first comment line of the file
};

std::vector<std::string> scene_folders();
/// The file that a scene's name or path means (scene_names.h). Warns if a folder that is not the program's own has a scene of the same name
/// as one that came with the program, and says which is used. Throws Error(input).
std::string scene_path(const std::string& name_or_path);
/// For a name that was looked up already: the same warning, if there is reason for one.
void warn_if_shadowed(const std::string& name_or_path);
std::vector<ShippedScene> shipped_scenes();

}  // namespace bump
