#pragma once
// The two names of a user's file: the path that opens it, which errors give, and the name from the scene's folder, which warnings and
// results give. The second never depends on where the program was called or where the scene lies, so results do not either.

#include <string>
#include <utility>

namespace bump {

struct FileName {
  FileName(const char* both) : path(both), shown(both) {}
  FileName(const std::string& both) : path(both), shown(both) {}
  FileName(std::string opened_as, std::string shown_as) : path(std::move(opened_as)), shown(std::move(shown_as)) {}

  std::string path;
  std::string shown;
};

/// The scene file itself: shown without its folder.
FileName scene_file_name(const std::string& path);

/// `name` as written in `referring_file`: relative to that file's folder unless it is absolute; backslashes (from other systems) become
/// slashes. An absolute name is shown as it is written.
FileName file_beside(const FileName& referring_file, const std::string& name);

}  // namespace bump
