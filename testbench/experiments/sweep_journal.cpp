#include "testbench/experiments/sweep_journal.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "datapath/error.h"
#include "datapath/invariant.h"

namespace bump {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* first_line = "{\"journal\": \"bumpsim-sweep\", \"version\": 1}\n";

[[noreturn]] void fail(const std::string& what, const std::string& path, int error) {
  throw Error({what, {path}, std::generic_category().message(error), "free space or rights there, or another folder with --out"});
}

/// A new entry of a folder is as lasting as the folder.
void sync_folder(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

void prepare_folder(const std::string& folder) {
  std::error_code error;
  if (folder.empty()) throw Error({"the output folder has no name", {}, "", "give one with --out"});
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    throw Error({"cannot use the output folder", {folder}, "a file of this name is in the way", "another folder with --out"});
  fs::create_directories(folder, error);
  if (error) fail("cannot create the output folder", folder, error.value());
  if (has_sweep_journal(folder)) return;
  if (!fs::is_empty(folder, error))
    throw Error(
        {"the output folder is in use", {folder}, "it is not empty and holds no sweep of bumpsim", "choose another folder with --out"});
}

/// Locks of this kind are not inherited by children, and go with the process however that ends.
void lock(int file, const std::string& folder) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(file, F_SETLK, &whole) == 0) return;
  if (errno == EACCES || errno == EAGAIN)
    throw Error({"another sweep works in the output folder", {folder}, "", "wait for it, or choose another folder with --out"});
  fail("cannot lock the journal", folder, errno);
}

}  // namespace

bool has_sweep_journal(const std::string& folder) {
  std::ifstream file(fs::path(folder) / SweepJournal::file_name, std::ios::binary);
  std::string line;
  if (!file) return false;
  std::getline(file, line);
  const std::string_view expected(first_line);
  // A process that was killed while it began may have left a part of the first line.
  return expected.compare(0, line.size(), line) == 0;
}

SweepJournal::SweepJournal(const std::string& folder, bool anew) : path_((fs::path(folder) / file_name).string()) {
  prepare_folder(folder);
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot open the journal", path_, errno);
  try {
    lock(file_, folder);
    struct stat facts {};
    const bool begun = ::fstat(file_, &facts) == 0 && facts.st_size >= static_cast<off_t>(std::string_view(first_line).size());
    if (anew || !begun) {
      if (::ftruncate(file_, 0) != 0) fail("cannot empty the journal", path_, errno);
      append(first_line);
      sync_folder(folder);
    }
    refresh();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

SweepJournal::~SweepJournal() {
  ::close(file_);
}

void SweepJournal::append(const std::string& lines) const {
  BUMP_ASSERT(!lines.empty() && lines.back() == '\n');
  // What was left of an earlier line ends here. One call: lines of several processes do not mix.
  const std::string bytes = lines == first_line ? lines : "\n" + lines;
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("cannot write the journal", path_, written == 0 ? EIO : errno);
    done += static_cast<std::size_t>(written);
  }
  if (::fdatasync(file_) != 0 && errno != EINVAL && errno != EROFS) fail("cannot write the journal", path_, errno);
}

std::string SweepJournal::read(std::int64_t offset, std::size_t size) const {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::pread(file_, bytes.data() + done, size - done, static_cast<off_t>(offset) + static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot read the journal", path_, errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

void SweepJournal::note(const std::string& line, std::int64_t offset) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return;  // cut off
  if (json.contains("checked") && json["checked"].is_string()) checked_.insert(json["checked"].get<std::string>());
  const bool is_point = json.contains("id") && json["id"].is_string() && json.contains("status") && json.contains("values");
  if (is_point) lines_[json["id"].get<std::string>()] = {offset, line.size()};
}

void SweepJournal::refresh() {
  constexpr std::size_t block = std::size_t{1} << 22;
  std::string rest;
  std::int64_t at = known_;  // of the rest
  for (std::string bytes = read(known_, block); !bytes.empty(); bytes = read(at + static_cast<std::int64_t>(rest.size()), block)) {
    rest += bytes;
    std::size_t begin = 0;
    for (std::size_t end = rest.find('\n'); end != std::string::npos; end = rest.find('\n', begin)) {
      if (end > begin) note(rest.substr(begin, end - begin), at + static_cast<std::int64_t>(begin));
      begin = end + 1;
    }
    rest.erase(0, begin);
    at += static_cast<std::int64_t>(begin);
  }
  known_ = at;
}

Json SweepJournal::point(const std::string& id) const {
  const Place& place = lines_.at(id);
  return Json::parse(read(place.offset, place.size));
}

}  // namespace bump
