// `bumpsim table2`: draws the pictures of Lee 2007's Table 2, measures them, and sets the values beside the published ones.

#include <fmt/core.h>

#include "schemes/scheme.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/table2.h"
#include "testbench/experiments/table2_formats.h"
#include "testbench/experiments/table2_pictures.h"
#include "testbench/experiments/table2_scenes.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/warning.h"
#include "testbench/results/output_file.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

int table2_command(const Table2Arguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  if (!arguments.out.empty()) check_output_file(arguments.out, arguments.force);
  if (!arguments.pictures.empty() && arguments.pictures == arguments.out)
    throw Error({"--out and --pictures name the same place '" + arguments.out + "'", {}, "one is a file, the other a folder", "another name for one of them"});
  if (!arguments.pictures.empty()) check_table2_pictures(arguments.pictures, arguments.force);
  std::vector<Scene> scenes;
  for (const Table2Scene& wanted : table2_scenes) {
    scenes.push_back(read_scene(find_scene_path(std::string(wanted.shipped), scene_folders())));
    for (const std::string& warning : scenes.back().warnings) warn(warning);
    for (const char* method : {"proposed", "kim"})
      for (const std::string& warning : warnings_of(scenes.back(), find_scheme(scheme_of(method)).page(), configuration)) warn(warning);
    stop_if_interrupted();
  }

  Progress progress("drawing table 2");
  Table2Options options;
  options.angles = arguments.angles;
  options.jobs = arguments.jobs;
  options.progress = [&progress](double share) { progress.update(share); };
  options.cancelled = &interrupted;
  const Table2 table = measure_table2(scenes, configuration, options);
  stop_if_interrupted();

  const std::string text = table2_text(table, configuration, arguments.json ? "json" : arguments.format);
  if (!arguments.pictures.empty()) write_table2_pictures(arguments.pictures, table, configuration, arguments.force);
  if (arguments.out.empty())
    fmt::print("{}", text);
  else
    write_output_file(arguments.out, text, arguments.force);
  return 0;
}

}  // namespace bump
