// `bumpsim merge`: puts the shards of a sweep together.

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "testbench/experiments/sweep_merge.h"
#include "testbench/experiments/sweep_tables.h"
#include "testbench/program/commands.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/warning.h"

namespace bump {

int merge_command(const MergeArguments& arguments) {
  watch_interrupts();
  std::vector<std::string> repeated;
  const std::vector<std::string> folders = distinct_folders(arguments.folders, repeated);
  for (const std::string& folder : repeated) warn(folder + " is named more than once, and counts once");
  const nlohmann::ordered_json manifest = merge_sweeps(folders, arguments.out, arguments.force);
  if (arguments.json) {
    fmt::print("{}\n", manifest.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return 0;
  }
  fmt::print("{} points of {} folders\ntables in {}\n  {}  {}  {}\n", manifest["rows"].get<std::size_t>(), folders.size(), arguments.out,
             sweep_csv_name, sweep_lines_name, sweep_manifest_name);
  return 0;
}

}  // namespace bump
