#include "testbench/program/shipped_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

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
