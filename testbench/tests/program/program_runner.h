#pragma once
// Runs the built program as a user would and collects what it said. For tests only.

#include <filesystem>
#include <string>

namespace bump {

struct Outcome {
  int code = -1;  ///< exit code
  std::string out, err;
};

/// Runs `WRAPPER bumpsim ARGUMENTS` through the shell in `folder`.
Outcome bumpsim(const std::string& arguments, const std::filesystem::path& folder, const std::string& wrapper = "");

/// A folder that is removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);

/// A small scene of its own, without files: a 12 x 12 cell plane and a sphere, 96 x 80 pixels.
std::string small_scene();

}  // namespace bump
