// Where the host's time goes: the dated run split into its parts, unit by unit, over scenes, schemes and frame sizes; and whether cost and
// memory per fragment stay the same when frames grow. Values without quality. Prints Markdown, two tables.
//   bench_stages [--rounds N] [--scenes a,b] [--schemes a,b] [--sizes 512,2048]

#include <sys/resource.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <systemc>

#include "system/simulation.h"
#include "testbench/bench/help_option.h"
#include "testbench/bench/interleaved.h"
#include "testbench/bench/list_option.h"
#include "testbench/program/configure.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

using namespace bump;
using Json = nlohmann::ordered_json;

namespace {

struct Settings {
  int rounds = 5;
  std::vector<std::string> scenes = {"wood_plane", "brick_cube", "world_sphere", "brick_torus", "bunny"};
  std::vector<std::string> schemes = {"lee2007"};
  std::vector<std::string> sizes = {"512"};
};

Settings settings_of(int argc, char* argv[]) {
  Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (i + 1 == argc) throw Error({"option '" + option + "' needs a value", {}, "", ""});
    const std::string value = argv[++i];
    if (option == "--rounds")
      s.rounds = std::max(1, std::atoi(value.c_str()));
    else if (option == "--scenes")
      s.scenes = bench::list_option(value);
    else if (option == "--schemes")
      s.schemes = bench::list_option(value);
    else if (option == "--sizes")
      s.sizes = bench::list_option(value);
    else
      throw Error({"unknown option '" + option + "'", {}, "", ""});
  }
  return s;
}

/// One run in a process of its own.
Json run_once(const Scene& scene, const Scheme& scheme) {
  const ChildTask task{"run", [&](const ReportShare&) {
                         SimulationOptions options;
                         options.measure = false;
                         const SimulationResult result = simulate(scene, scheme, configure({}, {}), options);
                         rusage usage{};
                         ::getrusage(RUSAGE_SELF, &usage);
                         Json json = {{"fragments", result.fragments}, {"peak_bytes", usage.ru_maxrss * 1024}};
                         json["frame_bytes"] = result.hardware.object.size() *
                                               (3 * sizeof(double) + sizeof(std::int32_t) + sizeof(double));  // colour, object, depth
                         json["parts"] = Json::object();
                         for (const HostTime& time : result.host_times) json["parts"][time.part] = time.seconds;
                         return json.dump();
                       }};
  ChildOptions one;
  one.jobs = 1;
  const ChildOutcome outcome = run_in_children({task}, one).front();
  if (outcome.error) throw Error(*outcome.error);
  return Json::parse(outcome.bytes);
}

struct Row {
  std::string scene, scheme;
  int size = 0;
  double fragments = 0, peak_bytes = 0, frame_bytes = 0;
  std::vector<HostTime> parts;  ///< medians
  double per_fragment_ns = 0;   ///< of all parts but the preparation
};

Row measure(Scene scene, const std::string& scheme, int size, int rounds) {
  scene.width = scene.height = size;
  Row row{scene.name, scheme, size, 0, 0, 0, {}, 0};
  std::map<std::string, std::vector<double>> seconds;
  std::vector<double> work;
  for (int round = 0; round < rounds; ++round) {
    const Json run = run_once(scene, find_scheme(scheme));
    row.fragments = run["fragments"];
    row.peak_bytes = run["peak_bytes"];
    row.frame_bytes = run["frame_bytes"];
    work.push_back(0);
    if (round == 0)
      for (const auto& [part, ignored] : run["parts"].items()) row.parts.push_back({part, 0});
    for (const auto& [part, value] : run["parts"].items()) {
      seconds[part].push_back(value);
      if (part != "preparation") work.back() += value.get<double>();
    }
  }
  for (HostTime& part : row.parts) part.seconds = bench::median(seconds[part.part]);
  row.per_fragment_ns = 1e9 * bench::median(work) / row.fragments;
  return row;
}

std::string parts_table(const std::vector<Row>& rows) {
  std::string text = "| scene | scheme | pixels | preparation, ms |";
  const std::vector<HostTime>& parts = rows.front().parts;
  for (std::size_t i = 1; i < parts.size(); ++i) text += fmt::format(" {} |", parts[i].part);
  text += " all units |\n|--|--|--:|--:|";
  for (std::size_t i = 0; i < parts.size(); ++i) text += "--:|";
  text += "\n";
  for (const Row& row : rows) {
    text += fmt::format("| {} | {} | {} | {:.0f} |", row.scene, row.scheme, row.size, 1e3 * row.parts.front().seconds);
    for (std::size_t i = 1; i < row.parts.size(); ++i) text += fmt::format(" {:.1f} |", 1e9 * row.parts[i].seconds / row.fragments);
    text += fmt::format(" {:.1f} |\n", row.per_fragment_ns);
  }
  return text;
}

std::string growth_table(const std::vector<Row>& rows) {
  std::string text =
      "| scene | scheme | pixels | million fragments | ns a fragment | peak memory, MB | of that the frame, MB "
      "|\n|--|--|--:|--:|--:|--:|--:|\n";
  for (const Row& row : rows)
    text += fmt::format("| {} | {} | {} | {:.3f} | {:.1f} | {:.0f} | {:.0f} |\n", row.scene, row.scheme, row.size, row.fragments / 1e6,
                        row.per_fragment_ns, row.peak_bytes / 1e6, row.frame_bytes / 1e6);
  return text;
}

int run(int argc, char* argv[]) {
  const Settings settings = settings_of(argc, argv);
  std::vector<Row> rows;
  for (const std::string& name : settings.scenes) {
    const Scene scene = read_scene(find_scene_path(name, scene_folders()));
    for (const std::string& scheme : settings.schemes)
      for (const std::string& size : settings.sizes) {
        std::fprintf(stderr, "%s %s %s\n", name.c_str(), scheme.c_str(), size.c_str());
        rows.push_back(measure(scene, scheme, std::max(1, std::atoi(size.c_str())), settings.rounds));
      }
  }
  fmt::print("{}\n{}", parts_table(rows), growth_table(rows));
  return 0;
}

}  // namespace

int sc_main(int argc, char* argv[]) {
  if (bench::gave_help(argc, argv, "where the time of a dated run goes, over scenes, schemes and frame sizes", "bench_stages [--rounds N] [--scenes a,b] [--schemes a,b] [--sizes 512,2048]")) return 0;
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    std::fprintf(stderr, "bench_stages: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
