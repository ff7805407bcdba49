#include "program_runner.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace bump {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Outcome bumpsim(const std::string& arguments, const fs::path& folder, const std::string& wrapper) {
  const TemporaryFolder logs;
  const std::string out = (logs.path() / "out").string(), err = (logs.path() / "err").string();
  const std::string command = "cd '" + folder.string() + "' && " + wrapper + " '" BUMP_PROGRAM "' >'" + out + "' 2>'" + err + "' </dev/null " + arguments;
  const int status = std::system(command.c_str());
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = read_file(out);
  outcome.err = read_file(err);
  return outcome;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "bumpsim-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::permissions(path_, fs::perms::owner_all, error);
  fs::remove_all(path_, error);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const fs::path file = path_ / name;
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

std::string small_scene() {
  return R"([frame]
width = 96
height = 80
[camera]
eye = [0.5, -3.2, 1.4]
target = [0, 0, 0]
up = [0, 0, 1]
field_of_view = 40
[[light]]
type = "directional"
direction = [0.6, -0.8, 0.9]
[[object]]
name = "ball"
shape = "sphere"
colour = [0.8, 0.7, 0.6]
[[object]]
name = "floor"
shape = "plane"
translate = [0, 0, -1]
colour = [0.4, 0.5, 0.6]
[object.material]
diffuse = 0.5
specular = 0.1
)";
}

}  // namespace bump
