#include "testbench/results/pending_folder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// What a signal handler needs, in memory that it may touch: fixed buffers, filled before `active` is set. State of the process, as
/// handlers are.
struct PartialState {
  std::atomic<bool> active{false};
  std::atomic<int> files{0};
  std::array<std::array<char, PATH_MAX>, 32> file{};
  std::array<char, PATH_MAX> folder{}, out{}, replaced{};
};
PartialState partial_state;

void copy_path(std::array<char, PATH_MAX>& buffer, const std::string& path) {
  BUMP_ASSERT(path.size() < buffer.size());
  std::memcpy(buffer.data(), path.c_str(), path.size() + 1);
}

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

[[noreturn]] void fail(const std::string& what, const std::string& path, const std::string& why) {
  throw Error({what, {path}, why, "free space or rights there, or choose another folder with --out"});
}

bool is_of_kind(const fs::path& folder, const FolderKind& kind) {
  std::ifstream file(folder / kind.files.front());
  if (!file) return false;
  const nlohmann::json document = nlohmann::json::parse(file, nullptr, false);
  return document.is_object() && document.value("schema", nlohmann::json()) == kind.schema;
}

/// Without trailing slash and symbolic links, so that "beside it" and "rename" mean what they say.
fs::path resolve(const std::string& out) {
  if (out.empty()) throw Error({"the output folder has no name", {}, "", "give one with --out"});
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) fail("cannot use the output folder", out, error.message());
  if (!path.has_filename()) path = path.parent_path();
  if (path.string().size() + 64 > PATH_MAX) fail("cannot use the output folder", out, reason(ENAMETOOLONG));
  return path;
}

/// The nearest folder above that exists must take a new entry.
void check_parent(const fs::path& out) {
  fs::path parent = out.parent_path();
  std::error_code error;
  while (fs::symlink_status(parent, error).type() == fs::file_type::not_found && parent.has_relative_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent, error)) fail("cannot create the output folder", out.string(), parent.string() + " is not a folder");
  if (::access(parent.c_str(), W_OK | X_OK) != 0)
    fail("cannot create the output folder", out.string(), reason(errno) + ": " + parent.string());
}

bool may_hold(const FolderKind& kind, const std::string& name) {
  return !name.empty() && std::find(kind.files.begin(), kind.files.end(), name) != kind.files.end();
}

/// Replacing the folder would take along whatever else lies in it.
void check_for_other_files(const fs::path& out, const FolderKind& kind) {
  std::error_code error;
  fs::directory_iterator entries(out, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path& path = entries->path();
    const bool known = may_hold(kind, path.filename().string());
    if (known && entries->symlink_status(error).type() == fs::file_type::regular) continue;
    throw Error({fmt::format("the output folder holds more than a {}", kind.name),
                 {path.string()},
                 "replacing it would remove this too",
                 "move it elsewhere, or choose another folder with --out"});
  }
  if (error) fail("cannot read the output folder", out.string(), error.message());
}

void check(const fs::path& out, bool force, const FolderKind& kind) {
  check_parent(out);
  std::error_code error;
  if (fs::is_symlink(out, error)) fail("cannot use the output folder", out.string(), "it is a symbolic link to nothing");
  const fs::file_status status = fs::status(out, error);
  if (status.type() == fs::file_type::not_found) return;
  if (error) fail("cannot use the output folder", out.string(), error.message());
  if (status.type() != fs::file_type::directory) fail("cannot use the output folder", out.string(), "a file of this name is in the way");
  const bool empty = fs::is_empty(out, error);
  if (error) fail("cannot read the output folder", out.string(), error.message());
  if (empty) return;
  if (!is_of_kind(out, kind)) {
    throw Error({"the output folder is in use",
                 {out.string()},
                 fmt::format("it is not empty and holds no {} of bumpsim", kind.name),
                 "choose another folder with --out"});
  }
  check_for_other_files(out, kind);
  if (!force) {
    throw Error(
        {fmt::format("the output folder holds an earlier {}", kind.name), {out.string()}, "", "replace it with --force, or choose another folder with --out"});
  }
}

}  // namespace

void check_output_folder(const std::string& out, bool force, const FolderKind& kind) {
  check(resolve(out), force, kind);
}

PendingFolder::PendingFolder(const std::string& out, bool force, const FolderKind& kind) : kind_(kind), force_(force) {
  const fs::path path = resolve(out);
  check(path, force, kind);
  out_ = path.string();
  const std::string process = std::to_string(::getpid());
  partial_ = out_ + ".partial-" + process;
  replaced_ = out_ + ".replaced-" + process;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) fail("cannot create the output folder", path.parent_path().string(), error.message());
  fs::remove_all(partial_, error);  // left by a process of the same number that was killed
  if (!fs::create_directory(partial_, error)) fail("cannot create the output folder", partial_, error.message());

  BUMP_ASSERT(!partial_state.active);
  copy_path(partial_state.folder, partial_);
  copy_path(partial_state.out, out_);
  copy_path(partial_state.replaced, replaced_);
  partial_state.files = 0;
  partial_state.active = true;
}

PendingFolder::~PendingFolder() {
  if (committed_) return;
  remove_partial_result();
  partial_state.active = false;
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
}

void PendingFolder::write(const std::string& name, std::string_view bytes) {
  const std::string path = partial_ + "/" + name;
  BUMP_ASSERT(may_hold(kind_, name));
  const int index = partial_state.files;
  BUMP_ASSERT(index < static_cast<int>(partial_state.file.size()));
  copy_path(partial_state.file[static_cast<std::size_t>(index)], path);
  partial_state.files = index + 1;

  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) fail("cannot create a result file", path, reason(errno));
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) error = errno;
    if (written == 0) error = EIO;
  }
  // Some file systems report a full disk only here.
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) fail("cannot write a result file", path, reason(error));
}

void PendingFolder::commit() {
  check(out_, force_, kind_);
  std::error_code error;
  const bool replace = fs::exists(out_, error) && !fs::is_empty(out_, error);
  if (replace && std::rename(out_.c_str(), replaced_.c_str()) != 0) fail("cannot replace the earlier result", out_, reason(errno));
  if (std::rename(partial_.c_str(), out_.c_str()) != 0) fail("cannot move the result into place", out_, reason(errno));
  partial_state.active = false;
  committed_ = true;
  if (replace) fs::remove_all(replaced_, error);
}

void remove_partial_result() noexcept {
  if (!partial_state.active) return;
  for (int i = 0; i < partial_state.files; ++i) ::unlink(partial_state.file[static_cast<std::size_t>(i)].data());
  ::rmdir(partial_state.folder.data());
  // Succeeds only between the two renames of commit(), when nothing stands in the place of the earlier result.
  (void)std::rename(partial_state.replaced.data(), partial_state.out.data());
}

}  // namespace bump
