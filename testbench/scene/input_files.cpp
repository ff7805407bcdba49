#include "testbench/scene/input_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "channels/parameters.h"
#include "datapath/sha256.h"

namespace bump {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30;

/// The file in the same folder whose name is nearest, for the advice.
std::string nearest_file(const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < 4096; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::string near = nearest_word(path.filename().string(), names);
  return near.empty() ? "" : (path.has_parent_path() ? (path.parent_path() / near).string() : near);
}

}  // namespace

std::string read_bytes(const std::string& path, const std::string& what, const Location& from, bool may_be_empty) {
  const Location where = from.file.empty() ? Location{path, 0, 0} : from;
  const std::string named = what + " '" + path + "'";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw Error({named + " does not exist", where,
                 from.file.empty() ? "paths on the command line are relative to the current folder"
                                   : "paths are relative to the file that names them",
                 nearest_file(path)});
  }
  if (fs::is_directory(status)) throw Error({named + " is a folder", where, "a file is expected here", ""});
  if (!fs::is_regular_file(status)) throw Error({named + " is not a regular file", where, error ? error.message() : "", ""});
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > largest_file) throw Error({named + " is too large", where, std::to_string(size) + " bytes, allowed 1 GiB", ""});
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  if (file) bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (!file || file.bad()) throw Error({named + " cannot be read", where, "the system refuses it", "check its permissions"});
  if (bytes.empty() && !may_be_empty) throw Error({named + " is empty", where, "it has 0 bytes", "restore or re-export the file"});
  return bytes;
}

std::string InputFiles::read(const FileName& name, const std::string& what, const Location& from) {
  std::string bytes = read_bytes(name.path, what, from);
  const bool listed = std::any_of(list_.begin(), list_.end(), [&](const auto& file) { return file.path == name.shown; });
  if (!listed) list_.push_back({name.shown, sha256_hex(bytes.data(), bytes.size())});
  return bytes;
}

}  // namespace bump
