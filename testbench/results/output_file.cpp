#include "testbench/results/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "datapath/error.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

[[noreturn]] void fail(const std::string& path, const std::string& why, const std::string& option) {
  throw Error({"cannot write the output file", {path}, why, "free space or rights there, or another file with " + option});
}

/// Absolute and without symbolic links, so that "beside it" and "rename" mean what they say.
fs::path resolve(const std::string& path, const std::string& option) {
  if (path.empty()) throw Error({"the output file has no name", {}, "", "give one with " + option});
  std::error_code error;
  if (!fs::path(path).has_filename()) fail(path, "that is a folder's name", option);
  fs::path resolved = fs::weakly_canonical(fs::absolute(path), error);
  if (error) fail(path, error.message(), option);
  return resolved;
}

void check(const fs::path& path, bool force, const std::string& option) {
  fs::path parent = path.parent_path();
  std::error_code error;
  while (fs::symlink_status(parent, error).type() == fs::file_type::not_found && parent.has_relative_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent, error)) fail(path.string(), parent.string() + " is not a folder", option);
  if (::access(parent.c_str(), W_OK | X_OK) != 0) fail(path.string(), reason(errno) + ": " + parent.string(), option);
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found) return;
  if (type == fs::file_type::directory) fail(path.string(), "a folder of this name is in the way", option);
  if (type != fs::file_type::regular) fail(path.string(), "it is no regular file", option);
  if (!force)
    throw Error({"the output file exists already", {path.string()}, "", "replace it with --force, or name another file with " + option});
}

/// 0, or the system's error.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) return errno;
    if (written == 0) return EIO;
  }
  return 0;
}

}  // namespace

void check_output_file(const std::string& path, bool force, const std::string& option) {
  check(resolve(path, option), force, option);
}

void check_replaced_file(const std::string& path, const std::string& beginning, const std::string& kind, const std::string& option) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return;
  std::string bytes(beginning.size(), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file.gcount() == 0 || bytes == beginning) return;
  throw Error({"'" + path + "' is no " + kind + ", so --force does not replace it",
               {},
               "",
               "another file with " + option + ", or remove that one"});
}

void write_output_file(const std::string& path, const std::string& text, bool force, const std::string& option) {
  const fs::path target = resolve(path, option);
  check(target, force, option);
  std::error_code made;
  fs::create_directories(target.parent_path(), made);
  if (made) fail(target.string(), made.message(), option);
  const std::string partial = target.string() + ".partial-" + std::to_string(::getpid());
  ::unlink(partial.c_str());  // left by a process of the same number that was killed
  const int file = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) fail(target.string(), reason(errno), option);
  int error = write_all(file, text);
  // Some file systems report a full disk only here.
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(partial.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  ::unlink(partial.c_str());
  fail(target.string(), reason(error), option);
}

}  // namespace bump
