#include "testbench/program/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <functional>
#include <new>
#include <system_error>

#include "channels/parameters.h"
#include "datapath/error.h"
#include "testbench/program/commands.h"
#include "testbench/program/failure_report.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/version.h"

namespace bump {

namespace {

void add_configuration(CLI::App& command, std::vector<std::string>& files, std::vector<std::string>& settings) {
  command.add_option("--config", files, "configuration file (TOML); may be repeated, later files win")->type_name("FILE")->allow_extra_args(false);
  command.add_option("--set", settings, "one parameter, e.g. fifos.depth=2; may be repeated, wins over files")->type_name("KEY=VALUE")->allow_extra_args(false);
}

void add_json(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "one JSON document on stdout");
}

/// Left to the commands, an empty path would mean the default.
CLI::Validator named() {
  return CLI::Validator([](std::string& text) { return text.empty() ? std::string("must not be empty") : std::string(); }, "");
}

/// The first word that is no option stands where the command belongs.
std::string misspelt_command(const CLI::App& program, int argc, char* argv[]) {
  if (!program.get_subcommands().empty()) return "";
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] != '-') return argv[i];
  return "";
}

ErrorText bad_usage(const CLI::App& program, const CLI::ParseError& error, int argc, char* argv[]) {
  const auto used = program.get_subcommands();
  ErrorText text;
  text.what = error.what();
  text.try_this = "bumpsim " + (used.empty() ? "" : used.front()->get_name() + " ") + "--help";
  const std::string word = misspelt_command(program, argc, argv);
  if (word.empty()) return text;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) names.push_back(command->get_name());
  text.what = "there is no command '" + word + "'";
  text.why = "the commands are: " + CLI::detail::join(names, ", ");
  const std::string near = nearest_word(word, names);
  if (!near.empty()) text.try_this = "bumpsim " + near;
  return text;
}

/// For usage errors, which come before the options are known.
bool asks_for_json(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + std::max(argc, 1), [](const char* argument) { return std::string(argument) == "--json"; });
}

ErrorText text_of(const std::string& what, const std::string& why, const std::string& try_this) {
  ErrorText text;
  text.what = what;
  text.why = why;
  text.try_this = try_this;
  return text;
}

}  // namespace

int command_line(int argc, char* argv[]) {
  guard_process();
  CLI::App program{"bumpsim: simulates bump-mapping hardware and says what it costs, how fast it is and how good its picture is",
                   "bumpsim"};
  program.require_subcommand(1);
  program.set_version_flag("--version", version_text());
  program.footer("Exit codes: 0 ok, 2 bad input or configuration, 3 deadlock, 4 self-check failed, 5 internal error, 130 interrupted.");
  std::function<int()> chosen;

  RunArguments run;
  CLI::App* command = program.add_subcommand("run", "simulate a scheme on a scene; writes a result folder and prints a summary");
  command->add_option("scene", run.scene, "a shipped scene, a scene file (.toml) or a mesh (.obj)")->required()->type_name("SCENE");
  command->add_option("--scheme", run.scheme, "see: bumpsim list schemes")->capture_default_str();
  command->add_option("--engine", run.engine, "dated (fast, exact) or stepped (clocked, for waveforms)")->capture_default_str();
  add_configuration(*command, run.configuration_files, run.settings);
  command->add_option("--out", run.out, "result folder; must not exist or be empty (default: a new one under ./out)")
      ->type_name("DIR")
      ->check(named());
  command->add_option("--trace", run.trace, "VCD file with FIFOs and unit states; needs --engine stepped; must not exist")
      ->type_name("FILE.vcd")
      ->check(named());
  command->add_option("--record", run.record, "file for what timing needs of this run, to be dated again by retime; must not exist")
      ->type_name("FILE")
      ->check(named());
  command->add_flag("--addresses", run.addresses, "with --record: keep what the caches are asked for as well, so that retime can change them")
      ->needs(command->get_option("--record"));
  command->add_flag("--force", run.force, "replace an earlier result in --out, and earlier files of --trace and --record");
  command->add_flag("--no-quality", run.no_quality,
                    "only cycles, counts and the picture: no references, no evaluation in double precision; faster");
  command->add_option("--jobs", run.jobs, "threads that draw the references and measure (default: one per core); results do not depend on it")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  add_json(*command, run.json);
  command->callback([&] { chosen = [&] { return run_command(run); }; });

  const auto add_format = [](CLI::App& to, std::string& format) {
    to.add_option("--format", format, "text, md, csv or json")->check(CLI::IsMember({"text", "md", "csv", "json"}))->capture_default_str();
  };
  const auto add_jobs = [](CLI::App& to, int& jobs) {
    to.add_option("--jobs", jobs, "simulations side by side (default: one per core); results do not depend on it")->check(CLI::Range(0, 1024))->type_name("N");
  };

  CompareArguments compare;
  command = program.add_subcommand("compare", "cost, speed and picture of several schemes on one scene, in one table");
  command->add_option("scene", compare.scene, "a shipped scene, a scene file (.toml) or a mesh (.obj)")->required()->type_name("SCENE");
  command->add_option("--schemes", compare.schemes, "ids with commas between, or all")->capture_default_str()->type_name("A,B,...");
  command->add_option("--engine", compare.engine, "dated or stepped; their numbers are the same")->capture_default_str();
  add_format(*command, compare.format);
  command->add_option("--out", compare.out, "folder for the table in every format and a picture of all frames side by side")->type_name("DIR")->check(named());
  add_configuration(*command, compare.configuration_files, compare.settings);
  add_jobs(*command, compare.jobs);
  command->add_flag("--force", compare.force, "replace an earlier comparison in --out");
  add_json(*command, compare.json);
  command->callback([&] { chosen = [&] { return compare_command(compare); }; });

  Table1Arguments table1;
  command = program.add_subcommand("table1", "Table 1 of Lee 2007: operators and tables of every scheme, derived beside published, with reasons");
  add_format(*command, table1.format);
  command->add_option("--out", table1.out, "file to write (default: stdout)")->type_name("FILE")->check(named());
  add_configuration(*command, table1.configuration_files, table1.settings);
  command->add_flag("--force", table1.force, "replace the file of --out");
  add_json(*command, table1.json);
  command->callback([&] { chosen = [&] { return table1_command(table1); }; });

  Table2Arguments table2;
  command = program.add_subcommand("table2", "Table 2 of Lee 2007: image quality by its measures, measured beside published");
  add_format(*command, table2.format);
  command->add_option("--out", table2.out, "file to write (default: stdout)")->type_name("FILE")->check(named());
  command->add_option("--pictures", table2.pictures, "folder for the images that are compared")->type_name("DIR")->check(named());
  command->add_flag("--angles", table2.angles, "also with the light at several angles from the viewer");
  add_configuration(*command, table2.configuration_files, table2.settings);
  add_jobs(*command, table2.jobs);
  command->add_flag("--force", table2.force, "replace the file of --out and the pictures");
  add_json(*command, table2.json);
  command->callback([&] { chosen = [&] { return table2_command(table2); }; });

  PriceArguments price;
  command = program.add_subcommand("price", "area and energy of schemes by tables of prices, and at which cost of tables two are equal");
  command->add_option("schemes", price.schemes, "ids with commas between, or all (default)")->type_name("SCHEME|all");
  command
      ->add_option("--prices", price.prices,
                   "a shipped table or a file (TOML); may be repeated: areas and energies from the first that has any (default: "
                   "osu018_model, horowitz45)")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false)
      ->check(named());
  command->add_option("--scene", price.scene, "count what this scene executes and moves, memory traffic included")
      ->type_name("SCENE")
      ->check(named());
  command->add_option("--break-even", price.break_even, "cost of a table bit and of a table read at which two schemes are equal")
      ->type_name("A,B")
      ->check(named());
  command->add_option("--real-bits", price.real_bits, "price interpolators and vertex work as fixed point of so many bits (default: floating point)")
      ->check(CLI::Range(1, 62))
      ->type_name("BITS");
  add_format(*command, price.format);
  command->add_flag("--items", price.items, "list every component of every unit");
  command->add_option("--out", price.out, "file to write (default: stdout)")->type_name("FILE")->check(named());
  add_configuration(*command, price.configuration_files, price.settings);
  add_jobs(*command, price.jobs);
  command->add_flag("--force", price.force, "replace the file of --out");
  add_json(*command, price.json);
  command->callback([&] { chosen = [&] { return price_command(price); }; });

  RetimeArguments retime;
  command =
      program.add_subcommand("retime",
                             "date a run recorded with --record again, for other depths, latencies, multiplier limits, memories; if recorded "
                             "with --addresses, for other caches as well");
  command->add_option("trace", retime.trace, "file that run --record wrote")->required()->type_name("TRACE");
  add_configuration(*command, retime.configuration_files, retime.settings);
  command->add_option("--sweep", retime.sweeps, "values of one parameter, e.g. fifos.depth=1,2,4; repeated: the full product")
      ->type_name("KEY=A,B,...")
      ->allow_extra_args(false);
  command->add_option("--format", retime.format, "text, csv or json")->check(CLI::IsMember({"text", "csv", "json"}))->capture_default_str();
  add_jobs(*command, retime.jobs);
  add_json(*command, retime.json);
  command->callback([&] { chosen = [&] { return retime_command(retime); }; });

  SweepArguments sweep;
  command = program.add_subcommand("sweep",
                                   "run all points of a specification and write them as one table; a sweep that was ended goes on where it "
                                   "stopped, and only points that changed run again");
  command->add_option("spec", sweep.spec, "scenes, schemes and parameters to vary (TOML)")->required()->type_name("SPEC.toml");
  command->add_option("--out", sweep.out, "folder for points.csv, points.jsonl, sweep.json and the journal of finished points")
      ->required()
      ->type_name("DIR")
      ->check(named());
  add_jobs(*command, sweep.jobs);
  command->add_option("--shard", sweep.shard, "run a part only, e.g. 2/3; bumpsim merge puts the parts together")->type_name("I/N")->check(named());
  command->add_option("--check", sweep.check, "points dated from traces that are also run in full, to compare: a number, 5%, or all")
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--force", sweep.force, "forget the points that --out has, and run all of them");
  add_json(*command, sweep.json);
  command->callback([&] { chosen = [&] { return sweep_command(sweep); }; });

  MergeArguments merge;
  command = program.add_subcommand("merge", "put the shards of a sweep together, as the whole sweep would have written them");
  command->add_option("folders", merge.folders, "folders of finished shards")->required()->type_name("DIR...");
  command->add_option("--out", merge.out, "folder to write")->required()->type_name("DIR")->check(named());
  command->add_flag("--force", merge.force, "replace an earlier sweep in --out");
  add_json(*command, merge.json);
  command->callback([&] { chosen = [&] { return merge_command(merge); }; });

  FitArguments fit;
  command = program.add_subcommand("fit", "the cheapest structure, widths and table sizes of schemes that reach a quality on the worst of several scenes");
  command->add_option("scenes", fit.scenes, "shipped scenes, scene files (.toml) or meshes (.obj)")->required()->type_name("SCENE...");
  command->add_option("--scheme,--schemes", fit.schemes, "ids with commas between, or all")->capture_default_str()->type_name("A,B,...");
  command->add_option("--psnr", fit.psnr_db, "quality to reach, in dB")->required()->check(CLI::Range(1.0, 200.0))->type_name("DB");
  command->add_option("--against", fit.against,
                      "what the fixed-point picture is compared with: the reference (so that a scheme's own errors count), or the scheme's double "
                      "evaluation (its words alone)")
      ->check(CLI::IsMember({"reference", "double"}))
      ->capture_default_str();
  command->add_option("--cost", fit.cost, "multipliers, adders, table_bits, area or energy (default: area or energy by --prices, else table_bits)")
      ->check(CLI::IsMember({"multipliers", "adders", "table_bits", "area", "energy"}));
  command->add_option("--prices", fit.prices, "a shipped table or a file (TOML); may be repeated: areas and energies from the first that has any")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false)
      ->check(named());
  command->add_option("--structure", fit.structure,
                      "search: a scheme's choices (filters, where angles are formed, ports ...) as well as its widths; keep: widths alone")
      ->check(CLI::IsMember({"search", "keep"}))->capture_default_str();
  command->add_option("--designs", fit.designs, "designs measured at most, for each scheme")->check(CLI::Range(1, 100000))->capture_default_str()->type_name("N");
  add_format(*command, fit.format);
  command->add_option("--out", fit.out, "file to write (default: stdout)")->type_name("FILE")->check(named());
  add_configuration(*command, fit.configuration_files, fit.settings);
  add_jobs(*command, fit.jobs);
  command->add_flag("--force", fit.force, "replace the file of --out");
  add_json(*command, fit.json);
  command->callback([&] { chosen = [&] { return fit_command(fit); }; });

  ParetoArguments pareto;
  command = program.add_subcommand("pareto", "which rows of a sweep's or a fit's table no other row beats in two columns; also as a plot");
  command->add_option("table", pareto.table, "folder of a sweep, or a file: CSV, JSON Lines, or JSON of a fit")->required()->type_name("DIR|FILE");
  command->add_option("--x", pareto.x, "column, or what only one column's name holds")->required()->type_name("COLUMN")->check(named());
  command->add_option("--y", pareto.y, "column, or what only one column's name holds")->required()->type_name("COLUMN")->check(named());
  command->add_option("--x-better", pareto.x_better, "low or high")->check(CLI::IsMember({"low", "high"}))->capture_default_str();
  command->add_option("--y-better", pareto.y_better, "low or high")->check(CLI::IsMember({"low", "high"}))->capture_default_str();
  command->add_option("--log", pareto.log, "axes of the plot with a logarithmic scale: x, y or xy")->check(CLI::IsMember({"x", "y", "xy"}));
  command->add_option("--label", pareto.label, "column that names and colours the points (default: scheme)")->type_name("COLUMN")->check(named());
  command->add_option("--where", pareto.where, "keep rows with this value only; may be repeated")->type_name("COLUMN=VALUE")->allow_extra_args(false);
  command->add_option("--out", pareto.out, "plot to write (SVG)")->type_name("FILE.svg")->check(named());
  command->add_option("--title", pareto.title, "of the plot");
  add_format(*command, pareto.format);
  command->add_flag("--force", pareto.force, "replace the file of --out");
  add_json(*command, pareto.json);
  command->callback([&] { chosen = [&] { return pareto_command(pareto); }; });

  ListArguments list;
  command = program.add_subcommand("list", "list schemes and shipped scenes");
  command->add_option("what", list.what, "schemes or scenes (default: both)")->check(CLI::IsMember({"schemes", "scenes"}));
  add_json(*command, list.json);
  command->callback([&] { chosen = [&] { return list_command(list); }; });

  DescribeArguments describe;
  command = program.add_subcommand("describe", "explain a scheme, a module and its parameters, one parameter, or the statistics");
  command->add_option("name", describe.name, "e.g. lee2007, texture_fetch, fifos.depth, statistics");
  add_json(*command, describe.json);
  command->callback([&] { chosen = [&] { return describe_command(describe); }; });

  CheckArguments check;
  command = program.add_subcommand("check", "read a scene, mesh or configuration file and say what is wrong with it");
  command->add_option("file", check.file)->required()->type_name("FILE");
  add_json(*command, check.json);
  command->callback([&] { chosen = [&] { return check_command(check); }; });

  LutsArguments luts;
  command = program.add_subcommand("luts", "write the ROM images of all schemes' tables and a manifest");
  command->add_option("--out", luts.out, "folder for the images")->capture_default_str()->type_name("DIR")->check(named());
  add_configuration(*command, luts.configuration_files, luts.settings);
  add_json(*command, luts.json);
  command->callback([&] { chosen = [&] { return luts_command(luts); }; });

  RtlArguments rtl;
  command = program.add_subcommand("rtl", "write a scheme's per-pixel units as Verilog, with vectors, test benches and checks by other tools");
  command->add_option("scheme", rtl.scheme, "see: bumpsim list schemes")->required()->type_name("SCHEME");
  command->add_option("--unit", rtl.units, "environment, illumination, conversion or light_map_address; may be repeated (default: all that there are)")
      ->type_name("UNIT")
      ->allow_extra_args(false);
  command->add_option("--scene", rtl.scene, "whose material the tables and constants have (default: the default material)")->type_name("SCENE");
  command->add_option("--vectors", rtl.vectors, "test vectors of each unit")->check(CLI::Range(2, 10000000))->capture_default_str()->type_name("N");
  command->add_option("--seed", rtl.seed, "of their random words")->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53))->capture_default_str()->type_name("S");
  command->add_option("--out", rtl.out, "folder to write; must not exist or be empty")->required()->type_name("DIR")->check(named());
  command->add_flag("--force", rtl.force, "replace an earlier folder of this command in --out");
  add_configuration(*command, rtl.configuration_files, rtl.settings);
  add_json(*command, rtl.json);
  command->callback([&] { chosen = [&] { return rtl_command(rtl); }; });

  ProbeArguments probe;
  command = program.add_subcommand("probe", "evaluate one unit's netlist on given inputs and print every node");
  command->add_option("scheme", probe.scheme)->required()->type_name("SCHEME");
  command->add_option("unit", probe.unit, "environment, illumination, conversion or vertex")->required()->type_name("UNIT");
  command->add_option("inputs", probe.assignments, "name=value; angles in degrees")->type_name("NAME=VALUE");
  add_configuration(*command, probe.configuration_files, probe.settings);
  add_json(*command, probe.json);
  command->callback([&] { chosen = [&] { return probe_command(probe); }; });

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return report_failure(ErrorKind::input, bad_usage(program, error, argc, argv), asks_for_json(argc, argv));
  }

  const bool json = run.json || compare.json || table1.json || table2.json || list.json || describe.json || check.json || luts.json || probe.json || rtl.json ||
                    retime.json || retime.format == "json" || compare.format == "json" || price.json || price.format == "json" || fit.json || fit.format == "json" || pareto.json || pareto.format == "json";
  try {
    const int code = chosen();
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category());
    return code;
  } catch (const Error& error) {
    return report_failure(error.kind(), error.text(), json);
  } catch (const std::system_error& error) {
    // Files are written with checks of their own; what is left is the program's own output.
    return report_failure(ErrorKind::input, text_of("cannot write to standard output", error.code().message(), ""), false);
  } catch (const std::bad_alloc&) {
    return report_failure(ErrorKind::input, text_of("out of memory", "", "a smaller frame or mesh"), json);
  } catch (const std::exception& error) {
    return report_failure(ErrorKind::internal, text_of("internal error", error.what(), "report this with the command that led to it"),
                          json);
  }
}

}  // namespace bump
