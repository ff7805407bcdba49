#pragma once
// A folder of files for tests of sweeps, removed with everything in it, with a small scene that needs no other file.

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "system/simulation.h"
#include "testbench/experiments/sweep_spec.h"

namespace bump {

class SweepFiles {
 public:
  SweepFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "bumpsim-sweep-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    write("ball.toml", scene_text("sphere"));
    write("wall.toml", scene_text("plane"));
  }
  ~SweepFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  SweepFiles(const SweepFiles&) = delete;
  SweepFiles& operator=(const SweepFiles&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return path(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  SweepSpec spec(const std::string& text) const { return read_sweep_spec(write("sweep.toml", text), all_parameters(), {}); }

  static std::string scene_text(const std::string& shape) {
    return "[frame]\nwidth = 32\nheight = 24\n[camera]\neye = [0, 0, 3]\n[[light]]\ndirection = [0.3, 0.4, 1]\n[[object]]\nshape = \"" +
           shape + "\"\ntessellation = 6\n";
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace bump
