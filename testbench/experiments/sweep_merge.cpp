#include "testbench/experiments/sweep_merge.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "datapath/error.h"
#include "testbench/experiments/sweep_journal.h"
#include "testbench/experiments/sweep_tables.h"
#include "testbench/scene/input_files.h"

namespace bump {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string in(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

[[noreturn]] void refuse(const std::string& folder, const std::string& what, const std::string& why, const std::string& try_this) {
  throw Error({what, {folder}, why, try_this});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

Json manifest_of(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    refuse(folder, "there is no such folder", "what is merged are the folders that bumpsim sweep wrote with --out",
           "the folders of finished sweeps");
  if (!fs::exists(in(folder, sweep_manifest_name), error))
    refuse(
        folder, "the folder holds no finished sweep", std::string("it has no ") + sweep_manifest_name,
        has_sweep_journal(folder) ? "let the sweep finish: the same command goes on where it stopped" : "the folders of finished sweeps");
  const Json manifest = Json::parse(read_bytes(in(folder, sweep_manifest_name), "sweep"), nullptr, false);
  if (!manifest.is_object() || manifest.value("schema", "") != sweep_schema || !manifest.contains("id"))
    refuse(in(folder, sweep_manifest_name), "the file does not describe a sweep", "", "the folders of finished sweeps");
  if (manifest.value("schema_version", 0) != sweep_schema_version)
    refuse(in(folder, sweep_manifest_name), "the sweep was written by another version of the program", "", "run it again");
  return manifest;
}

/// "1/3, 3/3".
std::string name_of(const Json& manifest) {
  const Json& shard = manifest["shard"];
  return shard.is_null() ? "all of it" : fmt::format("{}/{}", shard["index"].get<int>(), shard["of"].get<int>());
}

}  // namespace

std::vector<std::string> distinct_folders(const std::vector<std::string>& folders, std::vector<std::string>& repeated) {
  std::vector<std::string> distinct;
  for (const std::string& folder : folders) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const std::string& other) {
      std::error_code error;
      return folder == other || fs::equivalent(folder, other, error);
    });
    (known ? repeated : distinct).push_back(folder);
  }
  return distinct;
}

Json merge_sweeps(const std::vector<std::string>& folders, const std::string& out, bool force) {
  std::error_code error;
  for (const std::string& folder : folders)
    if (fs::equivalent(folder, out, error)) refuse(out, "the output folder is one of the shards", "", "another folder with --out");
  Json whole;
  std::string names;
  std::map<std::size_t, std::string> rows;  // by point
  for (const std::string& folder : folders) {
    const Json manifest = manifest_of(folder);
    if (whole.is_null()) whole = manifest;
    if (manifest["id"] != whole["id"])
      refuse(folder, "the folder holds another sweep than " + folders.front(), "specification, scenes or program differ",
             "shards of one sweep");
    names += (names.empty() ? "" : ", ") + name_of(manifest);
    std::size_t count = 0;
    for (std::string& line : lines_of(read_bytes(in(folder, sweep_lines_name), "sweep", {}, true))) {
      const Json row = Json::parse(line, nullptr, false);
      if (!row.is_object() || !row.contains("point") || !row["point"].is_number_unsigned())
        refuse(in(folder, sweep_lines_name), "a line of the table is damaged", "", "run the shard again");
      const auto [place, added] = rows.emplace(row["point"].get<std::size_t>(), line);
      if (!added && place->second != line)
        refuse(folder, fmt::format("point {} is not what another shard says of it", row["point"].get<std::size_t>()), "",
               "run both shards again with the same program");
      ++count;
    }
    if (count != manifest["rows"].get<std::size_t>())
      refuse(folder, "the table is incomplete", fmt::format("it has {} of {} rows", count, manifest["rows"].get<std::size_t>()),
             "run the shard again");
  }
  const auto points = whole["points"].get<std::size_t>();
  if (rows.size() != points)
    throw Error({fmt::format("{} of {} points are missing", points - rows.size(), points),
                 {},
                 "the folders are shards " + names,
                 "name the folders of all shards"});
  if (has_sweep_journal(out) && !force)
    refuse(out, "the output folder holds an earlier sweep", "", "replace it with --force, or choose another folder with --out");

  SweepJournal journal(out, true);
  remove_sweep_tables(out);
  SweepTables tables;
  std::set<std::string> ids;
  for (const auto& [point, line] : rows) {
    const Json row = Json::parse(line);
    ids.insert(row["id"].get<std::string>());
    tables.add(row);
  }
  // The merged folder can be gone on with, as any sweep's.
  for (const std::string& folder : folders) {
    std::string lines;
    for (const std::string& line : lines_of(read_bytes(in(folder, SweepJournal::file_name), "journal"))) {
      const Json entry = is_sound_journal_line(line) ? Json::parse(line, nullptr, false) : Json();
      const bool is_known = entry.is_object() && (ids.count(entry.value("id", "")) > 0 || ids.count(entry.value("checked", "")) > 0);
      if (is_known) lines += line + "\n";
    }
    if (!lines.empty()) journal.append(lines);
  }
  whole["shard"] = nullptr;
  whole["rows"] = tables.rows();
  whole["statuses"] = tables.statuses();
  tables.write(out, whole);
  return whole;
}

}  // namespace bump
