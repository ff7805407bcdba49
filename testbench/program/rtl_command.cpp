// `bumpsim rtl`: a scheme's per-pixel units as Verilog, with vectors, test benches and a Makefile for other people's tools.

#include <fmt/core.h>

#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/rtl_folder.h"
#include "testbench/program/rtl_manifest.h"
#include "testbench/program/shell_word.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/scene/only_material.h"
#include "testbench/scene/scene_file.h"

namespace bump {

int rtl_command(const RtlArguments& arguments) {
  watch_interrupts();
  check_rtl_folder(arguments.out, arguments.force);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  EmissionOptions options;
  options.units = arguments.units;
  if (!arguments.scene.empty()) {
    options.scene = arguments.scene;
    options.material = only_material(read_scene(scene_path(arguments.scene)));
  }
  options.vectors = arguments.vectors;
  options.seed = arguments.seed;
  Emission emission = emit(find_scheme(arguments.scheme), configuration, options);
  emission.files["README.md"] = rtl_readme(emission, configuration, options);
  const nlohmann::ordered_json manifest = rtl_manifest(emission, configuration, options);
  emission.files["rtl.json"] = manifest.dump(2) + "\n";
  write_rtl_folder(emission.files, arguments.out, arguments.force);
  if (arguments.json) {
    nlohmann::ordered_json document = {{"folder", arguments.out}};
    document.update(manifest);
    fmt::print("{}\n", document.dump(2));
    return 0;
  }
  fmt::print("{}{}: {} files; next: make -C {} check\n", rtl_summary(emission), arguments.out, emission.files.size(),
             shell_word(arguments.out));
  return 0;
}

}  // namespace bump
