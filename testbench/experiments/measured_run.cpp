#include "testbench/experiments/measured_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "memory/texture.h"
#include "testbench/experiments/tangent_fit.h"
#include "testbench/scene/config_file.h"

namespace bump {

namespace {

/// Few enough for every thread to get some, enough for a triangle to be set up once for many pixels.
constexpr int rows_of_band = 16;

Filter filter_of(const Configuration& configuration) {
  const std::string& name = configuration.choice("texture_fetch.filter");
  return name == "nearest" ? Filter::nearest : name == "bilinear" ? Filter::bilinear : Filter::trilinear;
}

void stop_if_set(const std::atomic<bool>* cancelled) {
  if (cancelled != nullptr && *cancelled) throw Error(ErrorKind::cancelled, {"interrupted", {}, "", "nothing was written"});
}

/// The image must be within the bound that the scheme states for its own quantisation. That bound takes every pixel at its worst; so a
/// picture that is off by a third of it must at least resemble the double evaluation: an error below a tenth of the picture's own energy.
void check_stated_bound(const RunReport& report) {
  const SimulationResult& result = *report.result;
  const Quality quality = compare_frames(result.hardware, result.exact, &result.diverged);
  const double floor = result.quantisation_floor_db;
  if (quality.pixels == 0 || floor <= 0) return;  // with bright lights the bound excludes nothing
  const double error = std::pow(10, -quality.psnr_db / 20), stated = std::min(1.0, std::pow(10, -floor / 20));
  const bool resembles = *std::max_element(quality.nmse.begin(), quality.nmse.end()) <= 0.1;
  if (error <= stated && (resembles || error <= std::clamp(stated / 3, 0.02, 0.1))) return;
  throw Error(
      ErrorKind::self_check,
      {fmt::format("self-check failed: the fixed-point picture is {:.1f} dB from the scheme's own double evaluation", quality.psnr_db),
       {},
       fmt::format("{} states at least {:.1f} dB for these widths", report.scheme->page().id, floor),
       "wider words, or report this as a fault of the scheme"});
}

}  // namespace

Engine engine_of(const std::string& name) {
  if (name != "dated" && name != "stepped")
    throw Error({"unknown engine '" + name + "'", {}, "the engines are: dated, stepped", "--engine dated"});
  return name == "dated" ? Engine::dated : Engine::stepped;
}

ReferenceDrawing::ReferenceDrawing(const Scene& scene, const Configuration& configuration, const std::atomic<bool>* cancelled)
    : cancelled_(cancelled),
      renderer_(scene, filter_of(configuration), has_blinn_reference(scene), configuration.choice("triangle_setup.cull") == "back",
                [this] {
                  stop_if_set(cancelled_);
                  stop_if_set(&abandoned_);
                }),
      bands_(
          scene.height, rows_of_band, [this](int first_row, int end_row) { renderer_.draw_rows(first_row, end_row); }, cancelled) {}

ReferenceDrawing::~ReferenceDrawing() {
  abandoned_ = true;
}

References ReferenceDrawing::finish() {
  bands_.finish();
  return renderer_.release();
}

References draw_references(const Scene& scene, const Configuration& configuration, const std::atomic<bool>* cancelled, int threads) {
  ReferenceDrawing drawing(scene, configuration, cancelled);
  drawing.begin(threads - 1);
  return drawing.finish();
}

namespace {

/// Schemes whose frame is Lee's need a flag for texture charts that run the wrong way round; most of them have a parameter for it.
void warn_of_mirrors(const Scene& scene, const SchemePage& page, const Configuration& configuration, std::vector<std::string>& warnings) {
  const std::string key = page.id + ".mirror";
  const bool has_flag = configuration.parameters().find(key) != nullptr;
  if (has_flag ? configuration.boolean(key) : page.mirrored_charts) return;
  for (const SceneObject& object : scene.objects) {
    const auto& vertices = object.mesh->vertices;
    if (std::none_of(vertices.begin(), vertices.end(), [](const Vertex& vertex) { return vertex.handedness <= 0; })) continue;
    warnings.push_back(fmt::format("object '{}' has mirrored texture coordinates, which {} shades wrongly{}", object.name, page.id,
                                   has_flag ? " without --set " + key + "=true" : ""));
  }
}

/// What helps where the tangents do not fit: a value of the same parameter that turns every texel, or another scheme.
std::string advice_on_tangents(const SchemePage& page, const Configuration& configuration) {
  const auto offers = [&](const std::string& key, const char* word) {
    const Parameter* parameter = configuration.parameters().find(key);
    return parameter != nullptr && std::count(parameter->choices.begin(), parameter->choices.end(), word) > 0;
  };
  if (offers(page.id + ".frame", "pixel")) return "--set " + page.id + ".frame=pixel";
  if (offers(page.id + ".normal", "matrix")) return "--set " + page.id + ".normal=matrix";
  return "a scheme for any tangents";
}

void warn_of_tangents(const Scene& scene, const SchemePage& page, const Configuration& configuration, std::vector<std::string>& warnings) {
  /// Degrees of the mean: what charts of parallels have by the meeting of their faces is far below, what was not made as one far above.
  constexpr double worth_saying = 2;
  const std::optional<Tangents> assumed = assumed_tangents(page, configuration);
  if (!assumed) return;
  const bool in_eye_space = configuration.choice("vertex_processor.space") == "eye";
  for (const SceneObject& object : scene.objects) {
    const ObjectSpace space = make_object_space(scene, object, glm::dmat4(1), in_eye_space ? ShadingSpace::eye : ShadingSpace::object);
    const TangentFit fit = tangent_fit(object, space, *assumed);
    if (fit.mean_degrees < worth_saying) continue;
    warnings.push_back(fmt::format(
        "object '{}' does not fit {}.frame={}{}: its tangents are {:.0f} degrees from {} on average (more than {:.0f} on {:.0f} % of the "
        "surface), and its relief is shaded as if turned by as much; try {}",
        object.name, page.id, configuration.choice(page.id + ".frame"), in_eye_space ? " along the camera's axes" : "", fit.mean_degrees,
        *assumed == Tangents::parallels ? "the parallels" : "the meridians", TangentFit::off_degrees, 100 * fit.off_share,
        advice_on_tangents(page, configuration)));
  }
}

}  // namespace

std::vector<std::string> warnings_of(const Scene& scene, const SchemePage& page, const Configuration& configuration) {
  std::vector<std::string> warnings;
  warn_of_mirrors(scene, page, configuration, warnings);
  warn_of_tangents(scene, page, configuration, warnings);
  return warnings;
}

MeasuredRun::MeasuredRun(const Scene& scene, const Scheme& scheme, const Configuration& configuration, const std::string& engine) {
  report_.scene = &scene;
  report_.scheme = &scheme;
  report_.configuration = &configuration;
  report_.result = &result_;
  report_.engine = engine;
  report_.resolved_toml = to_toml(configuration);
  report_.warnings = scene.warnings;
  for (const std::string& warning : warnings_of(scene, scheme.page(), configuration)) report_.warnings.push_back(warning);
}

void MeasuredRun::simulate(SimulationOptions options) {
  options.engine = engine_of(report_.engine);
  const auto begin = std::chrono::steady_clock::now();
  result_ = bump::simulate(*report_.scene, *report_.scheme, *report_.configuration, options);
  wall_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  for (const std::string& warning : warnings()) report_.warnings.push_back(warning);
}

void MeasuredRun::measure(const References& references, int threads) {
  for_row_bands(2, 1, threads, [&](int part, int) {
    if (part == 0) measure_quality(report_, &references.normal_map, references.blinn ? &*references.blinn : nullptr, threads);
    if (part == 1) check_stated_bound(report_);
  });
}

void MeasuredRun::draw_error_picture(FrameBuffer reference, int threads) {
  result_.exact = {};
  report_.error_picture = error_image(result_.hardware, std::move(reference), threads);
}

std::vector<std::string> MeasuredRun::warnings() const {
  std::vector<std::string> warnings;
  for (const LightMapUse& map : result_.light_maps) {
    if (map.counters.clipped == 0) continue;
    warnings.push_back(fmt::format("light map '{}' is too narrow for these lights: {} of {} reads are of words that were cut off", map.name,
                                   map.counters.clipped, map.counters.reads));
  }
  if (result_.fragments > 0) return warnings;
  const GeometryCounters& g = result_.geometry;
  warnings.push_back(
      fmt::format("nothing is seen: of {} triangles {} face away and {} are outside or cover no pixel; try --set triangle_setup.cull=none "
                  "or another camera",
                  g.triangles, g.triangles_culled, g.triangles_empty));
  return warnings;
}

}  // namespace bump
