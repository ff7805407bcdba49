// How far tangents are from those that a scheme takes for granted.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sweep_files.h"
#include "testbench/experiments/measured_run.h"
#include "testbench/experiments/tangent_fit.h"
#include "testbench/scene/scene_file.h"

using namespace bump;

namespace {

Scene scene_of(const SweepFiles& files, const std::string& shape) {
  return read_scene(files.write(shape + ".toml", SweepFiles::scene_text(shape)));
}

ObjectSpace own_axes(const Scene& scene) {
  return make_object_space(scene, scene.objects.front(), glm::dmat4(1));
}

/// The object with every tangent turned about its normal.
SceneObject turned(const SceneObject& object, double degrees) {
  Mesh mesh = *object.mesh;
  const double angle = degrees * 3.14159265358979323846 / 180;
  for (Vertex& vertex : mesh.vertices)
    vertex.tangent = std::cos(angle) * vertex.tangent + std::sin(angle) * glm::cross(vertex.normal, vertex.tangent);
  SceneObject result = object;
  result.mesh = std::make_shared<const Mesh>(mesh);
  return result;
}

Configuration configured(const std::vector<std::pair<std::string, std::string>>& settings) {
  Configuration configuration(all_parameters());
  for (const auto& [key, value] : settings) configuration.set_text(key, value, Location("test"));
  return configuration;
}

}  // namespace

TEST_CASE("the shapes are charts of parallels, and turned by an angle they are off by that angle") {
  const SweepFiles files;
  for (const std::string shape : {"sphere", "torus"}) {
    INFO(shape);
    const Scene scene = scene_of(files, shape);
    const SceneObject& object = scene.objects.front();
    CHECK(tangent_fit(object, own_axes(scene), Tangents::parallels).mean_degrees < 0.01);
    for (const double degrees : {3.0, 10.0, 45.0, 80.0}) {
      const TangentFit fit = tangent_fit(turned(object, degrees), own_axes(scene), Tangents::parallels);
      const double share_on_axis = shape == "sphere" ? 0.1 : 0.0;  // where any tangent will do
      CHECK(fit.mean_degrees <= degrees + 0.01);
      CHECK(fit.mean_degrees >= degrees * (1 - share_on_axis) - 0.01);
      CHECK((fit.off_share > 0.5) == (degrees > TangentFit::off_degrees));
    }
    // T and -T are one chart; what fits parallels is a quarter turn from meridians.
    CHECK(tangent_fit(turned(object, 180), own_axes(scene), Tangents::parallels).mean_degrees < 0.01);
    CHECK(tangent_fit(turned(object, 90), own_axes(scene), Tangents::meridians).mean_degrees < 0.01);
    CHECK(tangent_fit(object, own_axes(scene), Tangents::meridians).mean_degrees > 80);
    if (shape != "sphere") continue;  // on the inner half of a torus T runs the other way round
    // Downwards is one of the two directions of a meridian.
    const double down = tangent_fit(turned(object, -90), own_axes(scene), Tangents::downwards).mean_degrees,
                 up = tangent_fit(turned(object, 90), own_axes(scene), Tangents::downwards).mean_degrees;
    CHECK(std::min(down, up) < 15);
    CHECK(std::max(down, up) > 150);
  }
}

TEST_CASE("a plane that faces the z axis fits with any tangents") {
  const SweepFiles files;
  const Scene scene = scene_of(files, "plane");
  for (const double degrees : {0.0, 30.0, 90.0})
    CHECK(tangent_fit(turned(scene.objects.front(), degrees), own_axes(scene), Tangents::parallels).mean_degrees == 0);
}

TEST_CASE("what a scheme assumes follows from its settings") {
  const auto assumed = [](const std::string& scheme, const std::vector<std::pair<std::string, std::string>>& settings) {
    return assumed_tangents(find_scheme(scheme).page(), configured(settings));
  };
  CHECK(assumed("yp6", {}) == Tangents::parallels);
  CHECK(assumed("yp6", {{"yp6.frame", "meridian"}}) == Tangents::meridians);
  CHECK_FALSE(assumed("yp6", {{"yp6.frame", "pixel"}}).has_value());
  CHECK(assumed("lee2007", {{"lee2007.frame", "none"}}) == Tangents::downwards);
  CHECK_FALSE(assumed("lee2007", {}).has_value());
  CHECK(assumed("cart", {}) == Tangents::parallels);
  CHECK_FALSE(assumed("cart", {{"cart.normal", "matrix"}}).has_value());
  CHECK_FALSE(assumed("peercy1997", {}).has_value());
}

TEST_CASE("a scheme warns of a scene that its settings are not made for, and says what helps") {
  const SweepFiles files;
  Scene scene = scene_of(files, "torus");
  const auto warnings = [&](const std::string& scheme, const std::vector<std::pair<std::string, std::string>>& settings) {
    return warnings_of(scene, find_scheme(scheme).page(), configured(settings));
  };
  CHECK(warnings("yp6", {}).empty());
  CHECK(warnings("peercy1997", {{"vertex_processor.space", "eye"}}).empty());
  // Along the camera's axes no surface is a chart of parallels.
  scene.camera.eye = {2, -3, 1};
  scene.camera.up = {0, 0, 1};
  REQUIRE(warnings("yp6", {{"vertex_processor.space", "eye"}}).size() == 1);
  CHECK(warnings("yp6", {{"vertex_processor.space", "eye"}, {"yp6.frame", "pixel"}}).empty());
  scene.objects.front() = turned(scene.objects.front(), 40);
  for (const auto& [scheme, advice] : {std::pair<std::string, std::string>{"yp6", "--set yp6.frame=pixel"},
                                       {"lns", "--set lns.frame=pixel"},
                                       {"cart", "--set cart.normal=matrix"}}) {
    const std::vector<std::string> said = warnings(scheme, {});
    REQUIRE(said.size() == 1);
    CHECK_THAT(said.front(), Catch::Contains("40 degrees from the parallels") && Catch::Contains("100 %") && Catch::Contains(advice));
  }
  CHECK(warnings("lee2007", {}).empty());
}
