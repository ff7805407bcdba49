#include "luts/rom_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "datapath/error.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::error_code& error) {
  throw Error({"cannot write the ROM images",
               {path.string()},
               error.message(),
               "room and permission to write there, or another folder with --out"});
}

std::error_code system_error(int number) {
  return {number, std::generic_category()};
}

void write_file(const fs::path& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) cannot_write(path, system_error(errno));
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) error = errno;
    if (written == 0) error = EIO;
  }
  // Some file systems report a full disk only here.
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) cannot_write(path, system_error(error));
}

/// A folder that goes away with everything that is still in it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    fs::remove_all(path_, error);  // left by a process of the same number that was killed
    if (!fs::create_directory(path_, error)) cannot_write(path_, error);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void make_folder(const std::map<std::string, std::string>& files, const fs::path& folder, const std::string& process) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  if (error) cannot_write(folder.parent_path(), error);
  const TemporaryFolder written(folder.string() + process);
  for (const auto& [name, contents] : files) write_file(written.path() / name, contents);
  fs::rename(written.path(), folder, error);
  if (error) cannot_write(folder, error);
}

/// Renames one by one; keeps what they replace until all are in place.
class Replacement {
 public:
  Replacement(fs::path from, fs::path to, fs::path kept) : from_(std::move(from)), to_(std::move(to)), kept_(std::move(kept)) {}
  ~Replacement() {
    if (done_) return;
    std::error_code ignored;
    for (auto name = moved_.rbegin(); name != moved_.rend(); ++name) fs::remove(to_ / *name, ignored);
    for (const std::string& name : kept_names_) fs::rename(kept_ / name, to_ / name, ignored);
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  void replace(const std::string& name) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(to_ / name, error).type();
    if (type == fs::file_type::directory) cannot_write(to_ / name, system_error(EISDIR));
    if (type != fs::file_type::not_found) {
      fs::rename(to_ / name, kept_ / name, error);
      if (error) cannot_write(to_ / name, error);
      kept_names_.push_back(name);
    }
    fs::rename(from_ / name, to_ / name, error);
    if (error) cannot_write(to_ / name, error);
    moved_.push_back(name);
  }
  void done() { done_ = true; }

 private:
  fs::path from_, to_, kept_;
  std::vector<std::string> moved_, kept_names_;
  bool done_ = false;
};

}  // namespace

void write_rom_folder(const std::map<std::string, std::string>& files, const std::string& last, const std::string& folder) {
  std::error_code error;
  fs::path path = folder.empty() ? fs::path() : fs::weakly_canonical(fs::absolute(folder), error);
  if (!path.has_filename()) path = path.parent_path();
  if (error || path.empty()) cannot_write(folder, error ? error : system_error(ENOENT));
  const std::string process = ".partial-" + std::to_string(::getpid());
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found) return make_folder(files, path, process);
  if (type != fs::file_type::directory) cannot_write(path, system_error(ENOTDIR));

  // Inside the folder, as it may be a disk of its own.
  const TemporaryFolder kept(path / (".replaced" + process)), written(path / process);
  for (const auto& [name, contents] : files) write_file(written.path() / name, contents);
  Replacement replacement(written.path(), path, kept.path());
  for (const auto& [name, contents] : files)
    if (name != last) replacement.replace(name);
  replacement.replace(last);
  replacement.done();
}

}  // namespace bump
