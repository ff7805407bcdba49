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
std::vector<ShippedScene> shipped_scenes();

}  // namespace bump
