#pragma once
// What a sweep leaves in its folder: points.csv and points.jsonl, one row a point in the order of the specification, and sweep.json, which
// says of what, and whose presence says that the tables are complete. The bytes depend on the specification and the shard alone. No model
// of hardware.

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbench/experiments/sweep_plan.h"

namespace bump {

constexpr const char* sweep_schema = "bumpsim-sweep";
constexpr const char *sweep_manifest_name = "sweep.json", *sweep_lines_name = "points.jsonl", *sweep_csv_name = "points.csv";

/// A row: point, id, scene, scheme, frame, swept parameters, status, figures (sweep_columns.h), reason, warnings. `line`: of the journal.
nlohmann::ordered_json sweep_row(const SweepPlan& plan, std::size_t point, const nlohmann::ordered_json& line);

/// Everything about the sweep that its rows do not say; counts rows by their status.
nlohmann::ordered_json sweep_manifest(const SweepPlan& plan, const std::string& version, const Shard& shard,
                                      const std::map<std::string, std::size_t>& statuses, std::size_t rows);

/// Rows as text, for both tables.
class SweepTables {
 public:
  void add(const nlohmann::ordered_json& row);
  const std::map<std::string, std::size_t>& statuses() const { return statuses_; }
  std::size_t rows() const { return rows_; }
  /// Writes the three files, the manifest last, each complete or not at all. Throws Error(input).
  void write(const std::string& folder, const nlohmann::ordered_json& manifest) const;

 private:
  std::string csv_, lines_;
  std::size_t rows_ = 0;
  std::map<std::string, std::size_t> statuses_;
};

/// The part of a sweep whose tables the folder holds; missing if it holds no finished sweep.
std::optional<Shard> finished_shard(const std::string& folder);

/// Before a sweep goes on, so that no folder looks complete that is not.
void remove_sweep_tables(const std::string& folder);

/// Of statuses, the exit code that a sweep ends with: 5 for internal errors, 4 for failed self-checks; if every row failed, 3 or 2; else 0.
int exit_code_of(const std::map<std::string, std::size_t>& statuses);

}  // namespace bump
