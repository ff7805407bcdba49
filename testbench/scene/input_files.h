#pragma once
// Reads the files of a user and remembers them: every file that contributes to a scene is listed once, in order of reading, with the
// SHA-256 of its bytes, so that a result names exactly what it was made from.

#include <map>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/scene/file_name.h"
#include "units/scene.h"

namespace bump {

/// The bytes of `path`. `from` is the place that refers to it (a key in a scene file); without one the file itself is named. `what` names
/// the role ("texture", "scene"). Throws Error(input) if the file is missing, a folder, unreadable, empty or larger than 1 GiB.
std::string read_bytes(const std::string& path, const std::string& what, const Location& from = {}, bool may_be_empty = false);

class InputFiles {
 public:
  /// Like read_bytes, and lists the file under the name that results show.
  std::string read(const FileName& name, const std::string& what, const Location& from = {});
  const std::vector<Scene::InputFile>& list() const { return list_; }

 private:
  std::vector<Scene::InputFile> list_;
};

}  // namespace bump
