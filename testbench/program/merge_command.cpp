// `bumpsim merge`: puts the shards of a sweep together.

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "testbench/experiments/sweep_merge.h"
#include "testbench/experiments/sweep_tables.h"
#include "testbench/program/commands.h"
#include "testbench/program/interrupt.h"

namespace bump {

int merge_command(const MergeArguments& arguments) {
  watch_interrupts();
  const nlohmann::ordered_json manifest = merge_sweeps(arguments.folders, arguments.out, arguments.force);
  if (arguments.json) {
    fmt::print("{}\n", manifest.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return 0;
  }
  fmt::print("{} points of {} folders\ntables in {}\n  {}  {}  {}\n", manifest["rows"].get<std::size_t>(), arguments.folders.size(),
             arguments.out, sweep_csv_name, sweep_lines_name, sweep_manifest_name);
  return 0;
}

}  // namespace bump
