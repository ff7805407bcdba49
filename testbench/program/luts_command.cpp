// `bumpsim luts`: ROM images of the tables of every scheme, under the given configuration and the default material.

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "luts/write_roms.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/rom_sources.h"

namespace bump {

int luts_command(const LutsArguments& arguments) {
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  const std::vector<RomSource> sources = rom_sources(configuration);
  write_roms(sources, arguments.out);
  const auto files = rom_files(sources);
  if (arguments.json) {
    nlohmann::ordered_json document = {{"folder", arguments.out}, {"files", nlohmann::ordered_json::array()}};
    for (const auto& [name, text] : files) document["files"].push_back(name);
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  for (const auto& [name, text] : files) fmt::print("{}/{}\n", arguments.out, name);
  return 0;
}

}  // namespace bump
