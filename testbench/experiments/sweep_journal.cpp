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
#include "datapath/sha256.h"

namespace bump {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* first_line = "{\"journal\": \"bumpsim-sweep\", \"version\": 2}\n";
/// Of every version's first line.
constexpr const char* first_words = "{\"journal\": \"bumpsim-sweep\", \"version\": ";
constexpr std::size_t digits_of_sum = 12;

/// Between the object's own text and the digits; after them "}.
constexpr const char* sum_key = ",\"sum\":\"";

std::string sum_of(const std::string& text) {
  return sha256_hex(text.data(), text.size()).substr(0, digits_of_sum);
}

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

std::string journal_line(const std::string& object) {
  BUMP_ASSERT(object.size() > 2 && object.front() == '{' && object.back() == '}');
  return object.substr(0, object.size() - 1) + sum_key + sum_of(object) + "\"}\n";
}

bool is_sound_journal_line(const std::string& line) {
  const std::string text = !line.empty() && line.back() == '\n' ? line.substr(0, line.size() - 1) : line;
  const std::size_t tail = std::string_view(sum_key).size() + digits_of_sum + 2;
  if (text.size() <= tail || text.front() != '{' || text.compare(text.size() - tail, std::string_view(sum_key).size(), sum_key) != 0)
    return false;
  const std::string object = text.substr(0, text.size() - tail) + "}";
  return journal_line(object) == text + "\n";
}

bool has_sweep_journal(const std::string& folder) {
  std::ifstream file(fs::path(folder) / SweepJournal::file_name, std::ios::binary);
  std::string line;
  if (!file) return false;
  std::getline(file, line);
  const std::string_view expected(first_words);
  // A process that was killed while it began may have left a part of the first line.
  return expected.substr(0, line.size()) == std::string_view(line).substr(0, expected.size());
}

SweepJournal::SweepJournal(const std::string& folder, bool anew) : path_((fs::path(folder) / file_name).string()) {
  prepare_folder(folder);
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot open the journal", path_, errno);
  try {
    lock(file_, folder);
    begin(folder, anew);
    refresh();
    struct stat facts {};
    if (::fstat(file_, &facts) == 0 && facts.st_size > known_) damaged_.insert(lines_known_ + 1);  // it has no end
  } catch (...) {
    ::close(file_);
    throw;
  }
}

void SweepJournal::begin(const std::string& folder, bool anew) {
  const std::string_view expected(first_line);
  const std::string found = read(0, expected.size());
  const bool begun = found.size() == expected.size();
  if (begun && !anew && found != expected)
    throw Error({"the folder holds a sweep of another version of the program",
                 {folder},
                 "its journal is written in another way",
                 "another folder with --out, or --force to run all points again"});
  if (begun && !anew) return;
  if (::ftruncate(file_, 0) != 0) fail("cannot empty the journal", path_, errno);
  append(first_line);
  sync_folder(folder);
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
  if (offset == 0) return;  // the first line
  const Json json = is_sound_journal_line(line) ? Json::parse(line, nullptr, false) : Json();
  if (!json.is_object()) {
    damaged_.insert(lines_known_ + 1);
    return;
  }
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
      ++lines_known_;
      begin = end + 1;
    }
    rest.erase(0, begin);
    at += static_cast<std::int64_t>(begin);
  }
  known_ = at;
}

std::vector<std::string> SweepJournal::damages() const {
  std::vector<std::string> list;
  for (const std::int64_t line : damaged_) list.push_back(path_ + ", line " + std::to_string(line) + ", is damaged");
  return list;
}

Json SweepJournal::point(const std::string& id) const {
  const Place& place = lines_.at(id);
  return Json::parse(read(place.offset, place.size));
}

}  // namespace bump
