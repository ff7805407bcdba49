#pragma once
// What the tests of the readers share: a folder that goes away, files and pictures to put into it, and the error that an action throws.

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "units/scene.h"

namespace bump::test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file, making folders as needed, and returns its path.
  std::string write(const std::string& name, const std::string& content) const;
  /// Writes a picture; `values` in [0, 1], rows from the top; bits 8, 16 or 32 (floating point). The suffix gives the format.
  std::string write_image(const std::string& name, int width, int height, int channels, const std::vector<float>& values,
                          int bits = 8) const;

 private:
  std::string path_;
};

std::string read_file(const std::string& path);

/// The text of the Error(input) that `action` throws; fails the test if it throws none.
ErrorText error_of(const std::function<void()>& action);

/// Some warning contains `text`.
bool warns_of(const std::vector<std::string>& warnings, const std::string& text);

/// Frames are orthonormal, indices in range, triangles have area and face along their normals.
void check_mesh(const Mesh& mesh);

}  // namespace bump::test
