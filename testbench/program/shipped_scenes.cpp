#include "testbench/program/shipped_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "testbench/program/warning.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace fs = std::filesystem;

std::vector<std::string> scene_folders() {
  std::vector<std::string> folders;
  const auto offer = [&](const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) return;
    const std::string path = folder.lexically_normal().string();
    if (std::find(folders.begin(), folders.end(), path) == folders.end()) folders.push_back(path);
  };
  if (const char* set = std::getenv("BUMPSIM_SCENES")) offer(set);
  offer("scenes");
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) offer(program.parent_path().parent_path() / "scenes");
  offer(fs::path(BUMP_SOURCE_DIR) / "scenes");
  return folders;
}

std::string scene_path(const std::string& name_or_path) {
  const std::string path = find_scene_path(name_or_path, scene_folders());
  warn_if_shadowed(name_or_path);
  return path;
}

void warn_if_shadowed(const std::string& name_or_path) {
  if (fs::path(name_or_path).filename().string() != name_or_path || !fs::path(name_or_path).extension().empty()) return;
  std::vector<fs::path> files;  // of this name, in the order in which they are looked for
  for (const std::string& folder : scene_folders()) {
    const fs::path file = fs::path(folder) / (name_or_path + ".toml");
    std::error_code error;
    if (fs::is_regular_file(file, error)) files.push_back(file);
  }
  std::error_code error;
  if (files.size() < 2 || fs::equivalent(files.front(), files.back(), error)) return;
  // A copy that says the same is no other scene, though the files that it names may be others.
  warn("scene '" + name_or_path + "' is " + files.front().lexically_normal().string() + ", not " +
       files.back().lexically_normal().string() + " that came with the program; give a path to choose");
}

std::vector<ShippedScene> shipped_scenes() {
  std::vector<ShippedScene> scenes;
  for (const std::string& folder : scene_folders()) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() != ".toml") continue;
      ShippedScene scene{entry.path().stem().string(), ""};
      const bool known = std::any_of(scenes.begin(), scenes.end(), [&](const ShippedScene& s) { return s.name == scene.name; });
      if (known) continue;  // an earlier folder wins, as it does for `run`
      std::ifstream file(entry.path());
      std::string line;
      if (std::getline(file, line) && line.rfind("# ", 0) == 0) scene.title = line.substr(2);
      scenes.push_back(scene);
    }
  }
  std::sort(scenes.begin(), scenes.end(), [](const ShippedScene& a, const ShippedScene& b) { return a.name < b.name; });
  return scenes;
}

}  // namespace bump
