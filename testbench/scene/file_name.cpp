#include "testbench/scene/file_name.h"

#include <algorithm>
#include <filesystem>

namespace bump {

namespace fs = std::filesystem;

FileName scene_file_name(const std::string& path) {
  return {path, fs::path(path).filename().string()};
}

FileName file_beside(const FileName& referring_file, const std::string& name) {
  std::string portable = name;
  std::replace(portable.begin(), portable.end(), '\\', '/');
  const fs::path path(portable);
  const auto beside = [&](const std::string& file) {
    return (path.is_absolute() ? path : fs::path(file).parent_path() / path).lexically_normal().generic_string();
  };
  return {beside(referring_file.path), beside(referring_file.shown)};
}

}  // namespace bump
