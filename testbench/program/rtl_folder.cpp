#include "testbench/program/rtl_folder.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "datapath/error.h"
#include "testbench/program/interrupt.h"
#include "testbench/results/output_file.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "rtl.json";
constexpr const char* made_by_make = "build";

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw Error({what, {path.string()}, why, "free space or rights there, or choose another folder with --out"});
}

/// Without trailing slash and symbolic links, so that "beside it" and "rename" mean what they say.
fs::path resolve(const std::string& out) {
  if (out.empty()) throw Error({"the output folder has no name", {}, "", "give one with --out"});
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) fail("cannot use the output folder", out, error.message());
  return path.has_filename() ? path : path.parent_path();
}

/// The nearest folder above that exists must take a new entry.
void check_parent(const fs::path& out) {
  fs::path parent = out.parent_path();
  std::error_code error;
  while (fs::symlink_status(parent, error).type() == fs::file_type::not_found && parent.has_relative_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent, error)) fail("cannot create the output folder", out, parent.string() + " is not a folder");
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    fail("cannot create the output folder", out, std::generic_category().message(errno) + ": " + parent.string());
}

/// What the manifest of an earlier folder lists, with the folders on the way; empty if it is no folder of this kind.
std::set<std::string> listed(const fs::path& out) {
  std::ifstream file(out / manifest_name);
  const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  std::set<std::string> names;
  if (!document.is_object() || document.value("schema", nlohmann::json()) != rtl_schema) return names;
  names.insert(manifest_name);
  for (const nlohmann::json& name : document.value("files", nlohmann::json::array()))
    if (name.is_string())
      for (fs::path path = name.get<std::string>(); !path.empty(); path = path.parent_path()) {
        names.insert(path.string());
        if (path == path.parent_path()) break;
      }
  return names;
}

/// Replacing the folder would take along whatever else lies in it.
void check_for_other_files(const fs::path& out, const std::set<std::string>& names) {
  std::error_code error;
  fs::recursive_directory_iterator entries(out, error);
  for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
    const std::string name = entries->path().lexically_relative(out).string();
    const fs::file_type type = entries->symlink_status(error).type();
    const bool is_made = entries.depth() == 0 && name == made_by_make && type == fs::file_type::directory;
    if (is_made) entries.disable_recursion_pending();
    if (is_made || (names.count(name) > 0 && (type == fs::file_type::regular || type == fs::file_type::directory))) continue;
    throw Error({"the output folder holds more than emitted Verilog",
                 {entries->path().string()},
                 "replacing it would remove this too",
                 "move it elsewhere, or choose another folder with --out"});
  }
  if (error) fail("cannot read the output folder", out, error.message());
}

/// True if there is something to replace.
bool check(const fs::path& out, bool force) {
  check_parent(out);
  std::error_code error;
  if (fs::is_symlink(out, error)) fail("cannot use the output folder", out, "it is a symbolic link to nothing");
  const fs::file_status status = fs::status(out, error);
  if (status.type() == fs::file_type::not_found) return false;
  if (error) fail("cannot use the output folder", out, error.message());
  if (status.type() != fs::file_type::directory) fail("cannot use the output folder", out, "a file of this name is in the way");
  const bool empty = fs::is_empty(out, error);
  if (error) fail("cannot read the output folder", out, error.message());
  if (empty) return true;
  const std::set<std::string> names = listed(out);
  if (names.empty())
    throw Error({"the output folder is in use",
                 {out.string()},
                 "it is not empty and holds no Verilog of bumpsim",
                 "choose another folder with --out"});
  check_for_other_files(out, names);
  if (!force)
    throw Error(
        {"the output folder holds earlier Verilog", {out.string()}, "", "replace it with --force, or choose another folder with --out"});
  return true;
}

/// A folder that goes away with everything in it, unless it has been moved into place.
class PartialFolder {
 public:
  explicit PartialFolder(fs::path path) : path_(std::move(path)) { remove(); }  // left by a process of the same number that was killed
  ~PartialFolder() { remove(); }
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  void remove() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path_;
};

}  // namespace

void check_rtl_folder(const std::string& out, bool force) {
  check(resolve(out), force);
}

void write_rtl_folder(const std::map<std::string, std::string>& files, const std::string& out, bool force) {
  const fs::path target = resolve(out);
  check(target, force);
  const std::string process = std::to_string(::getpid());
  const PartialFolder partial(target.string() + ".partial-" + process);
  for (const auto& [name, text] : files) {
    write_output_file((partial.path() / name).string(), text, false);
    stop_if_interrupted();
  }
  const PartialFolder replaced(target.string() + ".replaced-" + process);
  std::error_code error;
  const bool replace = check(target, force);  // once more: time has passed
  if (replace) fs::rename(target, replaced.path(), error);
  if (error) fail("cannot replace the earlier folder", target, error.message());
  fs::rename(partial.path(), target, error);
  if (!error) return;
  std::error_code ignored;
  if (replace) fs::rename(replaced.path(), target, ignored);
  fail("cannot move the folder into place", target, error.message());
}

}  // namespace bump
