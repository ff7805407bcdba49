// Engines side by side: the clocked engine (a), the dated engine (c), and the same pipeline without dates (d), over shipped scenes and
// schemes; then FIFO depths. Times are those of the simulation alone, without quality: reading the scene, preparing designs, tables and
// maps (the same for all engines) and writing the result are not in them. Prints Markdown, and JSON with --json. Usage: bench_engines
// [--rounds N] [--size PIXELS] [--scenes a,b] [--schemes a,b] [--depths 1,4] [--json]

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <systemc>

#include "system/simulation.h"
#include "testbench/bench/help_option.h"
#include "testbench/bench/interleaved.h"
#include "testbench/bench/list_option.h"
#include "testbench/program/configure.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/version.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

using namespace bump;

namespace {

struct Settings {
  int rounds = 5, size = 512;
  std::vector<std::string> scenes = {"wood_plane", "brick_cube", "world_sphere", "brick_torus", "bunny"};
  std::vector<std::string> schemes = {"lee2007", "peercy1997", "kim2001"};
  std::vector<std::string> depths = {"1", "2", "4", "16", "256"};
  bool json = false;
};

Settings settings_of(int argc, char* argv[]) {
  Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--json") {
      s.json = true;
      continue;
    }
    if (i + 1 == argc) throw Error({"option '" + option + "' needs a value", {}, "", ""});
    const std::string value = argv[++i];
    if (option == "--rounds")
      s.rounds = std::max(1, std::atoi(value.c_str()));
    else if (option == "--size")
      s.size = std::max(1, std::atoi(value.c_str()));
    else if (option == "--scenes")
      s.scenes = bench::list_option(value);
    else if (option == "--schemes")
      s.schemes = bench::list_option(value);
    else if (option == "--depths")
      s.depths = bench::list_option(value);
    else
      throw Error({"unknown option '" + option + "'", {}, "", ""});
  }
  return s;
}

struct Row {
  std::string scene, scheme, depth;
  double cycles_per_fragment = 0, stepped_s = 0, dated_s = 0, untimed_s = 0;
  double stepped_to_dated = 0, dated_to_untimed = 0;
  std::int64_t fragments = 0;
};

double seconds_of(const Scene& scene, const Scheme& scheme, const Configuration& configuration, Engine engine) {
  SimulationOptions options;
  options.engine = engine;
  options.measure = false;
  const auto begin = std::chrono::steady_clock::now();
  const SimulationResult result = simulate(scene, scheme, configuration, options);
  const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return all - result.host_times.front().seconds;
}

Row measure(const Scene& scene, const std::string& id, const std::string& depth, int rounds) {
  const Scheme& scheme = find_scheme(id);
  const Configuration configuration = configure({}, {"fifos.depth=" + depth});
  const auto variant = [&](const std::string& name, Engine engine) {
    return bench::Variant{name, [&, engine] { return seconds_of(scene, scheme, configuration, engine); }};
  };
  const ChildTask count{"count", [&](const ReportShare&) {
                          SimulationOptions options;
                          options.measure = false;
                          const SimulationResult result = simulate(scene, scheme, configuration, options);
                          return fmt::format("{} {}", result.timing.cycles, result.fragments);
                        }};
  const ChildOutcome counted = run_in_children({count}, {}).front();
  if (counted.error) throw Error(*counted.error);
  long long cycles = 0, fragments = 0;
  std::sscanf(counted.bytes.c_str(), "%lld %lld", &cycles, &fragments);
  const bench::Interleaved taken = bench::interleaved(
      {variant("stepped", Engine::stepped), variant("dated", Engine::dated), variant("untimed", Engine::untimed)}, rounds);
  return {scene.name,        id,          depth,       static_cast<double>(cycles) / static_cast<double>(fragments),
          taken.of(0),       taken.of(1), taken.of(2), taken.ratio(0, 1),
          taken.ratio(1, 2), fragments};
}

std::string markdown(const std::vector<Row>& rows, const Settings& s) {
  std::string text = fmt::format("{} x {} pixels, median of {} rounds, {}\n\n", s.size, s.size, s.rounds, compiler_text());
  text += "| scene | scheme | FIFO depth | cycles per fragment | stepped / dated | dated / untimed | dated, million fragments a second |\n";
  text += "|--|--|--:|--:|--:|--:|--:|\n";
  for (const Row& row : rows)
    text += fmt::format("| {} | {} | {} | {:.2f} | {:.1f} | {:.2f} | {:.2f} |\n", row.scene, row.scheme, row.depth, row.cycles_per_fragment,
                        row.stepped_to_dated, row.dated_to_untimed, static_cast<double>(row.fragments) / row.dated_s / 1e6);
  return text;
}

std::string json(const std::vector<Row>& rows, const Settings& s) {
  nlohmann::ordered_json document = {
      {"schema", "bumpsim-bench-engines"}, {"rounds", s.rounds}, {"size", s.size}, {"compiler", compiler_text()}};
  document["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : rows)
    document["rows"].push_back({{"scene", row.scene},
                                {"scheme", row.scheme},
                                {"fifo_depth", row.depth},
                                {"fragments", row.fragments},
                                {"cycles_per_fragment", row.cycles_per_fragment},
                                {"stepped_s", row.stepped_s},
                                {"dated_s", row.dated_s},
                                {"untimed_s", row.untimed_s}});
  return document.dump(2) + "\n";
}

int run(int argc, char* argv[]) {
  const Settings settings = settings_of(argc, argv);
  std::vector<Row> rows;
  for (const std::string& name : settings.scenes) {
    Scene scene = read_scene(find_scene_path(name, scene_folders()));
    scene.width = scene.height = settings.size;
    for (const std::string& scheme : settings.schemes) {
      const bool all_depths = &scheme == &settings.schemes.front();
      for (const std::string& depth : all_depths ? settings.depths : std::vector<std::string>{"4"}) {
        std::fprintf(stderr, "%s %s depth %s\n", name.c_str(), scheme.c_str(), depth.c_str());
        rows.push_back(measure(scene, scheme, depth, settings.rounds));
      }
    }
  }
  fmt::print("{}", settings.json ? json(rows, settings) : markdown(rows, settings));
  return 0;
}

}  // namespace

int sc_main(int argc, char* argv[]) {
  if (bench::gave_help(argc, argv, "fragments a second of the engines, over scenes, schemes and FIFO depths", "bench_engines [--rounds N] [--size PIXELS] [--scenes a,b] [--schemes a,b] [--depths 1,4] [--json]")) return 0;
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_engines: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
