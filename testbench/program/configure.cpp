#include "testbench/program/configure.h"

#include "system/simulation.h"
#include "testbench/scene/config_file.h"

namespace bump {

Configuration configure(const std::vector<std::string>& files, const std::vector<std::string>& settings) {
  Configuration configuration(all_parameters());
  for (const std::string& file : files) read_configuration(file, configuration);
  for (const std::string& setting : settings) apply_setting(setting, configuration);
  return configuration;
}

}  // namespace bump
