#include "testbench/experiments/sweep_tables.h"

#include <filesystem>
#include <fstream>

#include "datapath/error.h"
#include "testbench/experiments/sweep_columns.h"
#include "testbench/experiments/sweep_sections.h"
#include "testbench/results/error_json.h"
#include "testbench/results/output_file.h"
#include "testbench/results/text_table.h"

namespace bump {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json value_json(const ParameterValue& value) {
  return std::visit([](const auto& plain) { return Json(plain); }, value);
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return to_string(ParameterValue(value.get<double>()));
  return value.dump();
}

Json joined(const Json& texts) {
  std::string all;
  for (const Json& text : texts) all += (all.empty() ? "" : "; ") + text.get<std::string>();
  return all.empty() ? Json(nullptr) : Json(all);
}

}  // namespace

Json sweep_row(const SweepPlan& plan, std::size_t point, const Json& line) {
  const PlannedPoint& planned = plan.points()[point];
  const Scene& scene = *plan.group_of(point).scene;
  Json row;
  row["point"] = point;
  row["id"] = planned.id;
  row[scene_key] = plan.spec().scenes[planned.spec.scene].name;
  row[scheme_key] = plan.spec().schemes[planned.spec.scheme]->page().id;
  row[width_key] = scene.width;
  row[height_key] = scene.height;
  for (std::size_t i = 0; i < plan.spec().keys.size(); ++i)
    row[plan.spec().keys[i]] =
        concerns(plan.spec().keys[i], *plan.spec().schemes[planned.spec.scheme]) ? value_json(planned.spec.values[i]) : Json(nullptr);
  row["status"] = line["status"];
  const std::vector<std::string>& columns = sweep_columns();
  for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = line["values"].is_array() ? line["values"].at(i) : Json(nullptr);
  row["reason"] = line["reason"];
  row["warnings"] = joined(line["warnings"]);
  return row;
}

Json sweep_manifest(const SweepPlan& plan, const std::string& version, const Shard& shard,
                    const std::map<std::string, std::size_t>& statuses, std::size_t rows) {
  const SweepSpec& spec = plan.spec();
  Json json;
  json["schema"] = sweep_schema;
  json["schema_version"] = sweep_schema_version;
  json["version"] = version;
  json["id"] = plan.id();
  json["shard"] = shard.of > 1 ? Json{{"index", shard.index}, {"of", shard.of}} : Json(nullptr);
  json["points"] = plan.points().size();
  json["rows"] = rows;
  json["statuses"] = statuses;
  json["scenes"] = Json::array();
  for (std::size_t i = 0; i < spec.scenes.size(); ++i) {
    Json inputs = Json::array();
    for (const Scene::InputFile& input : plan.scenes()[i].inputs) inputs.push_back({{"path", input.path}, {"sha256", input.sha256}});
    json["scenes"].push_back({{"name", spec.scenes[i].name}, {"inputs", inputs}});
  }
  json["schemes"] = Json::array();
  for (const Scheme* scheme : spec.schemes) json["schemes"].push_back(scheme->page().id);
  json["parameters"] = spec.keys;
  json["base"] = Json::object();
  for (const auto& [key, entry] : spec.base.entries())
    if (!(entry.value == spec.base.parameters().find(key)->fallback)) json["base"][key] = value_json(entry.value);
  json["quality"] = spec.quality;
  return json;
}

void SweepTables::add(const Json& row) {
  std::vector<std::string> header, cells;
  for (const auto& [name, value] : row.items()) {
    if (rows_ == 0) header.push_back(name);
    cells.push_back(cell(value));
  }
  if (rows_ == 0) csv_ = csv_line(header);
  csv_ += csv_line(cells);
  lines_ += row.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  ++rows_;
  ++statuses_[row["status"].get<std::string>()];
}

void SweepTables::write(const std::string& folder, const Json& manifest) const {
  const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
  write_output_file(path(sweep_lines_name), lines_, true, "--out");
  write_output_file(path(sweep_csv_name), csv_, true, "--out");
  write_output_file(path(sweep_manifest_name), manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n", true, "--out");
}

std::optional<Shard> finished_shard(const std::string& folder) {
  std::ifstream file(fs::path(folder) / sweep_manifest_name, std::ios::binary);
  if (!file) return std::nullopt;
  const Json manifest = Json::parse(file, nullptr, false);
  if (!manifest.is_object() || manifest.value("schema", "") != sweep_schema) return std::nullopt;
  const Json shard = manifest.value("shard", Json());
  if (!shard.is_object()) return Shard{};
  return Shard{shard.value("index", 1), shard.value("of", 1)};
}

void remove_sweep_tables(const std::string& folder) {
  // The manifest goes first: without it the folder does not look complete.
  for (const char* name : {sweep_manifest_name, sweep_csv_name, sweep_lines_name}) {
    std::error_code error;
    fs::remove(fs::path(folder) / name, error);
    if (error)
      throw Error(
          {"cannot remove an earlier table", {(fs::path(folder) / name).string()}, error.message(), "rights there, or another folder"});
    // Left by a process that was killed while it wrote.
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      if (entry->path().filename().string().rfind(std::string(name) + ".partial-", 0) == 0) fs::remove(entry->path(), error);
  }
}

int exit_code_of(const std::map<std::string, std::size_t>& statuses) {
  for (const ErrorKind kind : {ErrorKind::internal, ErrorKind::self_check})
    if (statuses.count(status_of(kind)) > 0) return static_cast<int>(kind);
  if (statuses.empty() || statuses.count("ok") > 0) return 0;
  return static_cast<int>(statuses.count(status_of(ErrorKind::deadlock)) > 0 ? ErrorKind::deadlock : ErrorKind::input);
}

}  // namespace bump
