// What shading along the camera's axes does to whole pictures.

#include <catch2/catch.hpp>

#include "../units/samples.h"
#include "system/simulation.h"
#include "testbench/experiments/child_processes.h"
#include "testbench/experiments/frame_bytes.h"
#include "testbench/reference/quality.h"

namespace bump {
namespace {

Scene small_scene() {
  Scene scene =
      samples::scene({samples::object(samples::sphere(16), glm::rotate(glm::dmat4(1), 0.7, glm::normalize(glm::dvec3(1, 2, 3))))}, 64, 48);
  scene.lights[1].intensity = 0.5;
  return scene;
}

struct Drawn {
  FrameBuffer frame;
  AngularError light;
};

/// Every scheme in both spaces, in double precision.
std::vector<Drawn> draw(const Scene& scene, const std::vector<std::string>& schemes, const std::vector<std::string>& settings = {}) {
  std::vector<ChildTask> tasks;
  for (const std::string& scheme : schemes) {
    for (const char* space : {"object", "eye"}) {
      tasks.push_back({scheme, [&, scheme, space](const ReportShare&) {
                         Configuration configuration(all_parameters());
                         configuration.set_text("numeric", "double", Location("test"));
                         configuration.set_text("vertex_processor.space", space, Location("test"));
                         for (const std::string& key : settings) configuration.set_text(scheme + "." + key, "pixel", Location("test"));
                         const SimulationResult result = simulate(scene, find_scheme(scheme), configuration, {});
                         std::string bytes;
                         append(bytes, result.hardware);
                         append(bytes, result.angular_errors.empty() ? AngularError{} : result.angular_errors[0]);
                         return bytes;
                       }});
    }
  }
  std::vector<Drawn> drawn;
  for (const ChildOutcome& outcome : run_in_children(tasks, {})) {
    if (outcome.error) throw *outcome.error;
    ByteReader reader(outcome.bytes);
    reader.read(drawn.emplace_back().frame);
    reader.read(drawn.back().light);
  }
  return drawn;
}

TEST_CASE("Cartesian schemes draw the same picture in both spaces, up to rounding") {
  const std::vector<std::string> schemes{"peercy1997", "ernst1998", "blinn1978", "phong1975"};
  const std::vector<Drawn> drawn = draw(small_scene(), schemes);
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    INFO(schemes[i]);
    const FrameBuffer &own = drawn[2 * i].frame, &eye = drawn[2 * i + 1].frame;
    CHECK(own.depth == eye.depth);
    CHECK(own.object == eye.object);
    CHECK(compare_frames(eye, own).pixels > 500);
    CHECK(compare_frames(eye, own).max_error < 1e-9);
  }
}

TEST_CASE("the approximate rotation of Lee 2007 draws another picture where its pole is elsewhere") {
  const std::vector<Drawn> drawn = draw(small_scene(), {"lee2007"});
  CHECK(compare_frames(drawn[1].frame, drawn[0].frame).mean_error > 2);
  CHECK(drawn[0].light.mean_degrees > 3);
  CHECK(drawn[1].light.mean_degrees > 3);
}

TEST_CASE("an exact polar rotation delivers the true light vector in both spaces") {
  const std::vector<Drawn> drawn = draw(small_scene(), {"exact_polar"}, {"angles"});
  for (const Drawn& one : drawn) {
    CHECK(one.light.count > 500);
    CHECK(one.light.mean_degrees < 0.2);  // interpolated vectors are not quite the true ones
  }
  CHECK(compare_frames(drawn[1].frame, drawn[0].frame).mean_error < 0.5);
}

}  // namespace
}  // namespace bump
