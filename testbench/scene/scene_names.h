#pragma once
// Scenes by name: "world_sphere" stands for world_sphere.toml in one of the folders of shipped scenes.

#include <string>
#include <vector>

namespace bump {

/// Names of the scene files (*.toml) in a folder, sorted; empty if there is no such folder.
std::vector<std::string> shipped_scenes(const std::string& folder);

/// The file that `name_or_path` means. A name without folder and suffix is looked up in `search_folders`, in order; anything else is a
/// path. Throws Error(input), with the nearest names, if there is no such file.
std::string find_scene_path(const std::string& name_or_path, const std::vector<std::string>& search_folders);

}  // namespace bump
