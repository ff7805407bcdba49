// The program of the co-simulation: `cosimulate plan` says how to translate emitted units for a scene, `cosimulate run` runs the clocked
// engine with them. scripts/cosimulate.sh puts both together.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <functional>
#include <systemc>

#include "testbench/cosimulation/cosimulation.h"
#include "testbench/cosimulation/plan.h"
#include "testbench/cosimulation/unit_library.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/program/configure.h"
#include "testbench/program/failure_report.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/version.h"
#include "testbench/results/output_file.h"
#include "testbench/results/pending_folder.h"
#include "testbench/results/result_folder.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

struct Arguments {
  std::string scene, scheme;
  std::vector<std::string> files, settings;
  std::string rtl;    ///< emitted folder
  std::string units;  ///< folder of translated units
  std::string out;
};

/// One line a unit: unit, top module, CAPACITY, TAIL. Ports go to <rtl>/cosimulation/<unit>_ports.h.
int plan(const Arguments& arguments) {
  const Configuration configuration = configure(arguments.files, arguments.settings);
  const Scene scene = read_scene(scene_path(arguments.scene));
  const std::vector<PlannedUnit> units = plan_units(scene, find_scheme(arguments.scheme), configuration);
  check_emitted(units, arguments.rtl);
  for (const PlannedUnit& unit : units) {
    write_output_file(arguments.rtl + "/cosimulation/" + unit.unit + "_ports.h", unit.ports, true);
    fmt::print("{} {} {} {}\n", unit.unit, unit.top, unit.capacity, unit.tail);
  }
  return 0;
}

int print(const std::vector<UnitReport>& reports) {
  int differing = 0;
  for (const UnitReport& unit : reports) {
    const auto& [tokens, wrong, first] = unit.handshake;
    fmt::print("{}: {}: {} tokens through Verilog, in_ready or out_valid other than the recurrences say in {} cycles{}{}\n",
               wrong == 0 ? "ok" : "FAILED", unit.unit, tokens, wrong, wrong == 0 ? "" : "; first: ", first);
    fmt::print("{}: {}: {} of {} result words differ from the model's{}{}\n", unit.words.different == 0 ? "ok" : "FAILED", unit.unit,
               unit.words.different, unit.words.words, unit.words.different == 0 ? "" : "; first: ", unit.words.first);
    if (!unit.agrees()) ++differing;
  }
  std::fflush(stdout);
  return differing;
}

/// What `bumpsim run --engine stepped` does, with the units in the place of their models.
int run(const Arguments& arguments) {
  const Configuration configuration = configure(arguments.files, arguments.settings);
  const Scheme& scheme = find_scheme(arguments.scheme);
  check_output_folder(arguments.out, false);
  const Scene scene = read_scene(scene_path(arguments.scene));
  check_cosimulation(scene, scheme, configuration);
  Cosimulation units(configuration, units_in(arguments.units), [&](const std::string& unit) { return load_unit(arguments.units, unit); });
  SimulationOptions options;
  options.stand_in = &units;
  MeasuredRun measured(scene, scheme, configuration, "stepped");
  measured.simulate(options);
  const int differing = print(units.reports());
  References references = draw_references(scene, configuration, nullptr, 1);
  measured.measure(references);
  measured.draw_error_picture(std::move(references.normal_map), 1);
  RunReport& report = measured.report();
  report.host = host_facts(measured.wall_s(), measured.result().fragments, compiler_text(), version_text());
  write_result(arguments.out, report, false);
  fmt::print("{} cycles, {} fragments in {:.1f} s: {}\n", measured.result().timing.cycles, measured.result().fragments, measured.wall_s(),
             arguments.out);
  return differing == 0 ? 0 : static_cast<int>(ErrorKind::self_check);
}

int cosimulate(int argc, char* argv[]) {
  CLI::App program("emitted units in the simulated pipeline; scripts/cosimulate.sh runs all of it", "cosimulate");
  program.require_subcommand(1);
  Arguments arguments;
  std::function<int()> chosen;
  const auto add = [&](const std::string& name, const std::string& description, int (*action)(const Arguments&)) {
    CLI::App* command = program.add_subcommand(name, description);
    command->add_option("scene", arguments.scene, "scene file or the name of a shipped scene")->required()->type_name("SCENE");
    command->add_option("scheme", arguments.scheme, "see: bumpsim list schemes")->required()->type_name("SCHEME");
    command->add_option("--config", arguments.files)->type_name("FILE")->allow_extra_args(false);
    command->add_option("--set", arguments.settings)->type_name("KEY=VALUE")->allow_extra_args(false);
    command->callback([&chosen, &arguments, action] { chosen = [&arguments, action] { return action(arguments); }; });
    return command;
  };
  add("plan", "say how to translate emitted units for a scene", plan)
      ->add_option("--rtl", arguments.rtl, "folder that `bumpsim rtl` has written")
      ->required()
      ->type_name("DIR");
  CLI::App* command = add("run", "run the clocked engine with translated units; writes a result folder like `bumpsim run`", run);
  command->add_option("--units", arguments.units, "folder with environment.so, illumination.so or both")->required()->type_name("DIR");
  command->add_option("--out", arguments.out, "result folder; must not exist or be empty")->required()->type_name("DIR");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    ErrorText text;
    text.what = error.what();
    text.try_this = "cosimulate --help";
    return report_failure(ErrorKind::input, text, false);
  }
  try {
    return chosen();
  } catch (const Error& error) {
    return report_failure(error.kind(), error.text(), false);
  } catch (const std::exception& error) {
    ErrorText text;
    text.what = "internal error";
    text.why = error.what();
    return report_failure(ErrorKind::internal, text, false);
  }
}

const int no_banner = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);

}  // namespace

}  // namespace bump

int sc_main(int argc, char* argv[]) {
  (void)bump::no_banner;
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  return bump::cosimulate(argc, argv);
}
