#include "testbench/scene/scene_names.h"

#include <algorithm>
#include <filesystem>

#include "channels/parameters.h"
#include "datapath/error.h"

namespace bump {

namespace fs = std::filesystem;

std::vector<std::string> shipped_scenes(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_scene_path(const std::string& name_or_path, const std::vector<std::string>& search_folders) {
  if (name_or_path.empty()) throw Error({"no scene is named", {}, "", "bumpsim list scenes"});
  std::error_code error;
  const bool is_name = fs::path(name_or_path).filename().string() == name_or_path && fs::path(name_or_path).extension().empty();
  if (is_name) {
    for (const auto& folder : search_folders) {
      const fs::path path = fs::path(folder) / (name_or_path + ".toml");
      if (fs::is_regular_file(path, error)) return path.lexically_normal().string();
    }
  }
  if (fs::is_regular_file(name_or_path, error)) return name_or_path;

  std::vector<std::string> names;
  for (const auto& folder : search_folders) {
    for (const auto& name : shipped_scenes(folder)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  const std::string near = nearest_word(fs::path(name_or_path).stem().string(), names);
  const std::string why = list.empty() ? "no folder of shipped scenes was found" : "the shipped scenes are " + list;
  if (fs::is_directory(name_or_path, error)) throw Error({"'" + name_or_path + "' is a folder, not a scene", {}, why, near});
  throw Error({(is_name ? "no scene is called '" : "there is no scene file '") + name_or_path + "'",
               {},
               why,
               near.empty() ? "bumpsim list scenes" : near});
}

}  // namespace bump
