#include "testbench/program/price_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "channels/parameters.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> price_folders() {
  std::vector<fs::path> folders;
  if (const char* set = std::getenv("BUMPSIM_PRICES")) folders.emplace_back(set);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "testbench/prices");
  folders.push_back(fs::path(BUMP_SOURCE_DIR) / "testbench/prices");
  return folders;
}

std::vector<std::string> shipped_prices() {
  std::vector<std::string> names;
  for (const fs::path& folder : price_folders()) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      if (entry->path().extension() == ".toml") names.push_back(entry->path().stem().string());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace

std::string find_price_table(const std::string& name_or_path) {
  const fs::path given(name_or_path);
  std::error_code error;
  if (!given.has_parent_path() && given.extension().empty())
    for (const fs::path& folder : price_folders())
      if (const fs::path file = folder / (name_or_path + ".toml"); fs::is_regular_file(file, error))
        return file.lexically_normal().string();
  if (fs::is_regular_file(given, error)) return name_or_path;
  const std::vector<std::string> names = shipped_prices();
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  const std::string near = nearest_word(given.stem().string(), names);
  throw Error({"there is no price table '" + name_or_path + "'",
               {},
               list.empty() ? "no folder of shipped tables was found" : "the shipped tables are " + list,
               near.empty() ? "--prices with one of them, or with a file" : "--prices " + near});
}

std::vector<PriceTable> read_price_tables(const std::vector<std::string>& names_or_paths) {
  std::vector<PriceTable> tables;
  for (const std::string& name : names_or_paths) tables.push_back(read_price_table(find_price_table(name)));
  return tables;
}

}  // namespace bump
