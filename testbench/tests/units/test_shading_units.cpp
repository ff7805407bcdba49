// Environment, illumination and colour unit: the netlists per light, in both arithmetics, and the report of angular errors.

#include <catch2/catch.hpp>
#include <cmath>

#include "datapath/inventory.h"
#include "samples.h"
#include "units/colour_unit.h"
#include "units/environment_unit.h"
#include "units/illumination_unit.h"
#include "units/interpolators.h"
#include "units/texture_fetch.h"

namespace bump {
namespace {

/// All units behind the rasterizer, one block after another.
struct Shading {
  std::shared_ptr<const PipelineContext> context;
  samples::Geometry geometry;
  Interpolators interpolators;
  TextureFetch texture;
  EnvironmentUnit environment;
  IlluminationUnit illumination;
  ColourUnit colour;

  explicit Shading(const Scene& scene, const ContextOptions& options = {})
      : context(samples::context(scene, options)),
        geometry(samples::rasterize(context)),
        interpolators(context),
        texture(context, {}),
        environment(context),
        illumination(context),
        colour(context, {}) {
    for (const auto& block : geometry.blocks) {
      interpolators.process(*block);
      texture.process(*block);
      environment.process(*block);
      illumination.process(*block);
      colour.process(*block);
    }
  }
  double hardware(const FragmentBlock& block, const std::string& plane, std::size_t lane) const {
    return block.hardware[static_cast<std::size_t>(context->planes.index(plane))][lane];
  }
  double exact(const FragmentBlock& block, const std::string& plane, std::size_t lane) const {
    return context->exact_plane(block, context->planes.index(plane))[lane];
  }
};

TEST_CASE("in double precision the colour is ambient plus every light's intensity, times the texel, clamped") {
  Scene scene = samples::crowded_scene();
  scene.lights[1].intensity = 0.25;
  Shading s(scene);
  std::int64_t lanes = 0;
  for (const auto& block : s.geometry.blocks) {
    lanes += block->lanes;
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      double sum = scene.objects[0].material.ambient;
      for (int light = 0; light < 2; ++light) {
        double dot = 0;
        for (const char* axis : {"x", "y", "z"})
          dot += s.exact(*block, plane_of_light(std::string("l.") + axis, light), lane) * s.exact(*block, std::string("map.") + axis, lane);
        sum += scene.lights[static_cast<std::size_t>(light)].intensity * std::clamp(dot, 0.0, 1.0);
      }
      for (const char* channel : {"r", "g", "b"}) {
        const double expected = std::clamp(sum * s.exact(*block, std::string("tex.") + channel, lane), 0.0, 1.0);
        REQUIRE(s.exact(*block, std::string("colour.") + channel, lane) == Approx(expected).margin(1e-12));
        REQUIRE(s.hardware(*block, std::string("colour.") + channel, lane) == Approx(expected).margin(0.03));
      }
    }
  }
  CHECK(s.environment.executions() == 2 * lanes);
  CHECK(s.illumination.executions() == 2 * lanes);
  CHECK(s.colour.executions() == lanes);
}

TEST_CASE("hardware planes hold words of their formats, and double runs keep a single set of planes") {
  const Scene scene = samples::crowded_scene();
  const Shading fixed(scene);
  bool differs = false;
  for (const auto& block : fixed.geometry.blocks) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      const double word = fixed.hardware(*block, "e.x#1", lane) * (1 << 14), colour = fixed.hardware(*block, "colour.g", lane) * (1 << 12);
      REQUIRE(word == std::floor(word));
      REQUIRE(colour == std::floor(colour));
      differs = differs || fixed.hardware(*block, "colour.g", lane) != fixed.exact(*block, "colour.g", lane);
    }
  }
  CHECK(differs);
  ContextOptions options;
  options.arithmetic = Arithmetic::real;
  const Shading real_run(scene, options);
  REQUIRE(real_run.geometry.blocks.size() == fixed.geometry.blocks.size());
  for (std::size_t b = 0; b < fixed.geometry.blocks.size(); ++b) {
    CHECK(real_run.geometry.blocks[b]->exact.empty());
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(fixed.geometry.blocks[b]->lanes); ++lane)
      REQUIRE(real_run.hardware(*real_run.geometry.blocks[b], "colour.b", lane) ==
              fixed.exact(*fixed.geometry.blocks[b], "colour.b", lane));
  }
}

TEST_CASE("the colour unit multiplies by light intensities only if one differs from 1") {
  Scene scene = samples::crowded_scene();
  const Inventory plain = count(colour_netlist(scene, scene.objects[0].material, {}));
  CHECK(plain.multipliers == 3);
  CHECK(plain.adders == 2);
  scene.lights[0].intensity = 2;
  CHECK(count(colour_netlist(scene, scene.objects[0].material, {})).multipliers == 5);
}

TEST_CASE("frames are right-handed and orthonormal, polar ones turn with the normal") {
  std::mt19937 random(41);
  const auto coordinate = [&] { return static_cast<double>(random() % 2001) / 1000.0 - 1; };
  for (int i = 0; i < 200; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate() + 1.5;
    const glm::dvec3 n(x, y, z), t(1, coordinate(), 0);
    for (const auto frame : {DeliveredDirection::Frame::tangent, DeliveredDirection::Frame::polar}) {
      const glm::dmat3 axes = delivery_frame(frame, n, t, glm::cross(n, t));
      REQUIRE(glm::determinant(axes) == Approx(1));
      REQUIRE(glm::length(axes[2] - glm::normalize(n)) < 1e-12);
      REQUIRE(std::fabs(glm::dot(axes[0], axes[2])) < 1e-12);
      REQUIRE(std::fabs(glm::dot(axes[0], axes[1])) < 1e-12);
    }
    // e_theta points away from the pole, e_phi along growing phi.
    const glm::dmat3 polar = delivery_frame(DeliveredDirection::Frame::polar, n, t, t);
    REQUIRE(polar[0].z <= 0);
    REQUIRE(polar[1].z == 0);
    REQUIRE(polar[1].x * -y + polar[1].y * x >= 0);
  }
  CHECK(delivery_frame(DeliveredDirection::Frame::tangent, {0, 0, 1}, {1, 0, 0}, {0, -1, 0})[1].y == -1);
  CHECK(angle_between({1, 0, 0}, {1, 1, 0}) == Approx(45));
  CHECK(angle_between({1, 0, 0}, {0, 0, 0}) == 90);
  CHECK(glm::length(polar_direction(0.25, 0.25) - glm::dvec3(0, 1, 0)) < 1e-15);
}

TEST_CASE("on a plane the delivered light direction is exact in double precision, and close in fixed point") {
  ContextOptions options;
  options.probe_directions = true;
  const Scene scene = samples::scene({samples::object(samples::plane(2), glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 1, 0)))});
  const Shading s(scene, options);
  const std::vector<AngularError> hardware = s.environment.meter().hardware(), exact = s.environment.meter().exact();
  REQUIRE((hardware.size() == 1 && exact.size() == 1));
  CHECK(hardware[0].vector == "L'");
  CHECK(hardware[0].count == 2 * s.geometry.raster.fragments);
  // The light vector of a point light is affine in the position, so interpolating it is exact.
  CHECK(exact[0].max_degrees < 1e-5);
  CHECK(hardware[0].max_degrees > 1e-5);
  CHECK(hardware[0].max_degrees < 0.05);
  CHECK(hardware[0].mean_degrees <= hardware[0].rms_degrees);
  CHECK(hardware[0].rms_degrees <= hardware[0].max_degrees);
  CHECK(Shading(scene).environment.meter().hardware().empty());
}

TEST_CASE("angular errors measured by a thread of its own are the same to the last bit") {
  ContextOptions options;
  options.probe_directions = true;
  const Scene scene = samples::scene({samples::object(samples::sphere(24))});
  const Shading at_once(scene, options);
  options.measure_aside = true;
  const Shading aside(scene, options);
  for (const bool exact : {false, true}) {
    const auto errors_of = [exact](const Shading& s) { return exact ? s.environment.meter().exact() : s.environment.meter().hardware(); };
    const AngularError expected = errors_of(at_once)[0], error = errors_of(aside)[0];
    CHECK(error.count == expected.count);
    CHECK(error.mean_degrees == expected.mean_degrees);
    CHECK(error.rms_degrees == expected.rms_degrees);
    CHECK(error.max_degrees == expected.max_degrees);
  }
}

TEST_CASE("only vectors that light the surface count for angular errors") {
  ContextOptions options;
  options.probe_directions = true;
  Scene scene = samples::scene({samples::object(samples::sphere(24))});
  scene.lights.resize(1);
  scene.lights[0].vector = glm::normalize(glm::dvec3(1, 0.2, -0.1));  // from the side: about half of what is seen lies in the dark
  const Shading s(scene, options);
  std::int64_t lit = 0;
  for (const auto& block : s.geometry.blocks) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      glm::dvec3 n;
      const char* axes[3] = {"x", "y", "z"};
      for (int c = 0; c < 3; ++c) n[c] = s.exact(*block, std::string("probe.N.") + axes[c], lane);
      lit += glm::dot(n, scene.lights[0].vector) > 0 ? 1 : 0;
    }
  }
  CHECK(lit > s.geometry.raster.fragments / 4);
  CHECK(lit < 3 * s.geometry.raster.fragments / 4);
  for (const AngularError& error : {s.environment.meter().hardware()[0], s.environment.meter().exact()[0]}) {
    CHECK(error.count == lit);
    CHECK(error.max_degrees > 0);
  }
}

TEST_CASE("a surface that no light reaches has no angular errors, not errors of 0") {
  ContextOptions options;
  options.probe_directions = true;
  Scene scene = samples::scene({samples::object(samples::plane(2))});
  scene.lights = {{true, {0, 0, -1}, 1}, {false, {1, 2, -4}, 1}, {true, {1, 0, 0}, 1}};  // two from behind, one along the surface
  const Shading s(scene, options);
  CHECK(s.geometry.raster.fragments > 0);
  for (const AngularError& error : {s.environment.meter().hardware()[0], s.environment.meter().exact()[0]}) {
    CHECK(error.vector == "L'");
    CHECK(error.count == 0);
    CHECK(std::isnan(error.mean_degrees));
    CHECK(std::isnan(error.rms_degrees));
    CHECK(std::isnan(error.max_degrees));
  }
}

TEST_CASE("a design that writes over a name that others read is refused") {
  const Scene scene = samples::scene({samples::object(samples::plane(1))});
  std::vector<Design> designs;
  designs.push_back(samples::design());
  designs[0].environment.output("n.x", {0});
  CHECK_THROWS_AS(make_context(scene, std::move(designs), {0}, {}), Error);
  std::vector<Design> two;
  two.push_back(samples::design());
  two.push_back(samples::design());
  two[1].map.channels[2].name = "w";
  CHECK_THROWS_AS(make_context(scene, std::move(two), {0}, {}), Error);
}

TEST_CASE("the colour unit in fixed point follows double precision for every light intensity") {
  for (const double intensity : {0.0, 0.3, 1.0, 2.5, 17.0, 100.0}) {
    for (const double diffuse : {0.001, 0.02, 0.3, 1.0}) {
      Scene scene;
      scene.lights.resize(2);
      for (Light& light : scene.lights) light.intensity = intensity;
      scene.objects.emplace_back();
      scene.objects[0].material = {0.1, diffuse, 0.01, 10};
      const Netlist netlist = colour_netlist(scene, scene.objects[0].material, {});
      const auto fixed = make_evaluator(netlist, Arithmetic::fixed), real_valued = make_evaluator(netlist, Arithmetic::real);
      for (const double dot : {0.0, 0.4, 1.0}) {
        std::vector<double> values;
        for (const Netlist::Port& port : netlist.inputs()) values.push_back(port.name.rfind("tex", 0) == 0 ? 0.9 : diffuse * dot);
        std::vector<const double*> inputs;
        for (const double& value : values) inputs.push_back(&value);
        double got[3], wanted[3];
        double* got_at[3] = {got, got + 1, got + 2};
        double* wanted_at[3] = {wanted, wanted + 1, wanted + 2};
        fixed->evaluate(inputs.data(), 1, got_at);
        real_valued->evaluate(inputs.data(), 1, wanted_at);
        INFO(intensity << " x " << diffuse << " x " << dot);
        // The intensity word is rounded to 2^-13 before the gains multiply it.
        REQUIRE(got[0] == Approx(wanted[0]).margin(0.001 + 2 * (intensity + 2) / 4096));
      }
    }
  }
}

}  // namespace
}  // namespace bump
