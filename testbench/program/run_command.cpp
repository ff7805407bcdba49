// `bumpsim run`: reads the scene, simulates, measures the picture against the references, writes the result folder, prints the summary.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "system/simulation.h"
#include "testbench/program/commands.h"
#include "testbench/program/configure.h"
#include "testbench/program/interrupt.h"
#include "testbench/program/progress.h"
#include "testbench/program/shipped_scenes.h"
#include "testbench/program/trace_file.h"
#include "testbench/program/version.h"
#include "testbench/program/warning.h"
#include "testbench/reference/reference_renderer.h"
#include "testbench/results/pending_folder.h"
#include "testbench/results/result_json.h"
#include "testbench/results/run_report.h"
#include "testbench/results/summary.h"
#include "testbench/results/result_folder.h"
#include "testbench/scene/config_file.h"
#include "testbench/scene/scene_file.h"
#include "testbench/scene/scene_names.h"

namespace bump {

namespace {

namespace fs = std::filesystem;

/// The first of out/<scene>-<scheme>, out/<scene>-<scheme>-2 ... that does not exist: an earlier result is never touched.
std::string new_output_folder(const std::string& scene, const std::string& scheme) {
  const fs::path base = fs::path("out") / (scene + "-" + scheme);
  fs::path folder = base;
  for (int number = 2; fs::exists(fs::symlink_status(folder)); ++number) folder = base.string() + "-" + std::to_string(number);
  return folder.string();
}

Engine engine_of(const RunArguments& arguments) {
  if (arguments.engine != "dated" && arguments.engine != "stepped")
    throw Error({"unknown engine '" + arguments.engine + "'", {}, "the engines are: dated, stepped", "--engine dated"});
  const Engine engine = arguments.engine == "dated" ? Engine::dated : Engine::stepped;
  if (engine == Engine::dated && !arguments.trace.empty())
    throw Error({"--trace needs the clocked engine", {}, "the dated engine has no signals to write", "--engine stepped --trace " + arguments.trace});
  return engine;
}

Filter filter_of(const Configuration& configuration) {
  const std::string& name = configuration.choice("texture_fetch.filter");
  return name == "nearest" ? Filter::nearest : name == "bilinear" ? Filter::bilinear : Filter::trilinear;
}

void measure(RunReport& report, const Scene& scene, const Configuration& configuration) {
  const Filter filter = filter_of(configuration);
  const bool cull = configuration.choice("triangle_setup.cull") == "back";
  const FrameBuffer reference = render_reference(scene, filter, ReferenceNormals::normal_map, cull);
  stop_if_interrupted();
  FrameBuffer blinn;
  if (has_blinn_reference(scene)) blinn = render_reference(scene, filter, ReferenceNormals::blinn, cull);
  stop_if_interrupted();
  measure_quality(report, &reference, blinn.width > 0 ? &blinn : nullptr);
}

/// Schemes whose frame is Lee's need a flag for texture charts that run the wrong way round, and have a parameter for it.
void warn_of_mirrored_charts(const Scene& scene, const std::string& scheme, const Configuration& configuration) {
  const std::string key = scheme + ".mirror";
  if (configuration.parameters().find(key) == nullptr || configuration.boolean(key)) return;
  for (const SceneObject& object : scene.objects) {
    for (const Vertex& vertex : object.mesh->vertices) {
      if (vertex.handedness > 0) continue;
      warn(fmt::format("object '{}' has mirrored texture coordinates, which {} shades wrongly without --set {}=true", object.name, scheme, key));
      break;
    }
  }
}

void warn_if_nothing_is_seen(const SimulationResult& result) {
  if (result.fragments > 0) return;
  const GeometryCounters& g = result.geometry;
  warn(fmt::format("nothing is seen: of {} triangles {} face away and {} are outside or cover no pixel; try --set triangle_setup.cull=none or another camera",
                   g.triangles, g.triangles_culled, g.triangles_empty));
}

/// The image must be within the bound that the scheme states for its own quantisation. That bound takes every pixel at its worst; so a picture
/// that is off by a third of it must at least resemble the double evaluation: an error below a tenth of the picture's own energy.
void check_stated_bound(const RunReport& report) {
  const SimulationResult& result = *report.result;
  FrameBuffer continuous = result.hardware;
  for (std::size_t pixel = 0; pixel < continuous.object.size(); ++pixel)
    if (result.diverged[pixel] != 0) continuous.object[pixel] = -1;  // and so left out of the comparison
  const Quality quality = compare_frames(continuous, result.exact);
  const double floor = result.quantisation_floor_db;
  if (quality.pixels == 0) return;
  const double error = std::pow(10, -quality.psnr_db / 20), stated = std::min(1.0, std::pow(10, -floor / 20));
  const bool resembles = *std::max_element(quality.nmse.begin(), quality.nmse.end()) <= 0.1;
  if (error <= stated && (resembles || error <= std::clamp(stated / 3, 0.02, 0.1))) return;
  throw Error(ErrorKind::self_check,
              {fmt::format("self-check failed: the fixed-point picture is {:.1f} dB from the scheme's own double evaluation", quality.psnr_db), {},
               fmt::format("{} states at least {:.1f} dB for these widths", report.scheme->page().id, floor), "wider words, or report this as a fault of the scheme"});
}

}  // namespace

int run_command(const RunArguments& arguments) {
  const std::atomic<bool>& interrupted = watch_interrupts();
  const Engine engine = engine_of(arguments);
  const Configuration configuration = configure(arguments.configuration_files, arguments.settings);
  const Scheme& scheme = find_scheme(arguments.scheme);
  if (!arguments.out.empty()) check_output_folder(arguments.out, arguments.force);
  const Scene scene = read_scene(find_scene_path(arguments.scene, scene_folders()));
  for (const std::string& warning : scene.warnings) warn(warning);
  warn_of_mirrored_charts(scene, arguments.scheme, configuration);
  const std::string out = arguments.out.empty() ? new_output_folder(scene.name, arguments.scheme) : arguments.out;
  check_output_folder(out, arguments.force);

  TraceFile trace(arguments.trace, out, arguments.force);

  SimulationOptions options;
  options.engine = engine;
  options.measure = !arguments.no_quality;
  options.trace = trace.stem();
  options.cancelled = &interrupted;
  Progress progress("simulating " + scene.name);
  options.progress = [&progress](double share) { progress.update(share); };
  const auto begin = std::chrono::steady_clock::now();
  const SimulationResult result = simulate(scene, scheme, configuration, options);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  trace.check(result.timing.cycles);

  warn_if_nothing_is_seen(result);

  RunReport report;
  report.scene = &scene;
  report.scheme = &scheme;
  report.configuration = &configuration;
  report.result = &result;
  report.engine = arguments.engine;
  report.resolved_toml = to_toml(configuration);
  if (!arguments.no_quality) {
    measure(report, scene, configuration);
    check_stated_bound(report);
  }
  report.host = host_facts(wall_s, result.fragments, compiler_text(), version_text());
  stop_if_interrupted();
  report.out = out;
  write_result(out, report, arguments.force);
  trace.commit();
  fmt::print("{}", arguments.json ? json_text(report) : summary(report));
  return 0;
}

}  // namespace bump
