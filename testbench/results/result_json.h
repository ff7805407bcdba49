#pragma once
// result.json: one document that holds everything a run counted and measured. Its layout is a contract, versioned by `schema_version`:
// fields are added without a new version, and never change their meaning within one. Not applicable is null or absent, never 0.
// Deterministic but for `host`. No model of hardware.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "testbench/results/run_report.h"

namespace bump {

constexpr const char* result_schema = "bumpsim-result";
constexpr int result_schema_version = 1;

nlohmann::ordered_json to_json(const RunReport& report);
/// The document as text, indented by two, ended by a newline. Bytes of paths that are not UTF-8 become U+FFFD.
std::string json_text(const RunReport& report);
/// One comparison. Identical images have a null psnr_db and a note that says so.
nlohmann::ordered_json to_json(const Quality& quality);

}  // namespace bump
