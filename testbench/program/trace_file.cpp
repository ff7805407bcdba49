#include "testbench/program/trace_file.h"

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
#include <system_error>
#include <vector>

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// What a signal handler needs, in memory that it may touch: filled before `active` is set. State of the process, as handlers are.
struct PartialTrace {
  std::atomic<bool> active{false};
  std::array<char, PATH_MAX> path{};
};
PartialTrace partial_trace;

std::string reason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
  throw Error({"cannot write the trace", {path}, why, "another file with --trace"});
}

/// Absolute and without symbolic links, so that "beside it", "inside" and "rename" mean what they say.
fs::path resolve(const std::string& path) {
  std::error_code error;
  fs::path resolved = fs::weakly_canonical(fs::absolute(path), error);
  if (error) cannot_write(path, error.message());
  return resolved.has_filename() ? resolved : resolved.parent_path();
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

struct Contents {
  std::int64_t time_stamps = 0;
  bool ends_with_line = false;
};

Contents read_through(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Contents contents;
  std::vector<char> block(std::size_t{1} << 20);
  bool line_begins = true;
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
    for (auto byte = block.begin(); byte != block.begin() + file.gcount(); ++byte) {
      if (line_begins && *byte == '#') ++contents.time_stamps;
      line_begins = *byte == '\n';
    }
  }
  contents.ends_with_line = file.eof() && line_begins;
  return contents;
}

}  // namespace

TraceFile::TraceFile(const std::string& given, const std::string& out, bool force) : force_(force) {
  if (given.empty()) return;
  std::error_code error;
  if (fs::is_directory(given, error) || !fs::path(given).has_filename()) cannot_write(given, "it is a folder, not a file");
  const fs::path path = resolve(fs::path(given).extension() == ".vcd" ? given : given + ".vcd");
  path_ = path.string();
  if (lies_in(path, resolve(out))) cannot_write(given, "the result folder appears as a whole, and holds nothing else");
  check_target();
  const std::string stem = path_.substr(0, path_.size() - 4) + ".partial-" + std::to_string(::getpid());
  partial_ = stem + ".vcd";
  if (partial_.size() >= PATH_MAX) cannot_write(given, reason(ENAMETOOLONG));

  ::unlink(partial_.c_str());  // left by a process of the same number that was killed
  const int file = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) cannot_write(path_, reason(errno));
  ::close(file);
  BUMP_ASSERT(!partial_trace.active);
  std::memcpy(partial_trace.path.data(), partial_.c_str(), partial_.size() + 1);
  partial_trace.active = true;
  stem_ = stem;
}

TraceFile::~TraceFile() {
  if (stem_.empty()) return;
  remove_partial_trace();
  partial_trace.active = false;
}

void TraceFile::check_target() const {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path_, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::directory) cannot_write(path_, "it is a folder, not a file");
  if (status.type() != fs::file_type::regular && status.type() != fs::file_type::symlink) cannot_write(path_, "it is no regular file");
  if (!force_) throw Error({"the trace exists already", {path_}, "", "replace it with --force, or name another file with --trace"});
}

void TraceFile::check(std::int64_t cycles) const {
  if (stem_.empty()) return;
  check_target();
  const Contents contents = read_through(partial_);
  const std::int64_t expected = 2 * cycles;
  if (contents.time_stamps >= expected && contents.ends_with_line) return;
  throw Error({"cannot write the trace",
               {path_},
               fmt::format("only {} of its {} clock edges are in the file: the disk is full, or files may not grow so large",
                           std::min(contents.time_stamps, expected), expected),
               "free space there, another file with --trace, a smaller frame, or no trace"});
}

void TraceFile::commit() {
  if (stem_.empty()) return;
  if (std::rename(partial_.c_str(), path_.c_str()) != 0) cannot_write(path_, reason(errno));
  partial_trace.active = false;
  stem_.clear();
}

void remove_partial_trace() noexcept {
  if (partial_trace.active) ::unlink(partial_trace.path.data());
}

}  // namespace bump
