// The interpolators: components between exact corners, angles the short way round, and the hardware that is counted.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "datapath/inventory.h"
#include "samples.h"
#include "units/interpolators.h"

namespace bump {
namespace {

TEST_CASE("components are the weighted corners, and positions interpolate to the point that the ray hits") {
  Scene scene = samples::scene({samples::object(samples::sphere(8))});
  ContextOptions options;
  options.probe_directions = true;
  const auto context = samples::context(scene, options);
  const samples::Geometry geometry = samples::rasterize(context);
  Interpolators unit(context);
  const auto plane = [&](const FragmentBlock& block, const std::string& name) -> const Lanes& {
    return block.hardware[static_cast<std::size_t>(context->planes.index(name))];
  };
  int fragments = 0;
  for (const auto& block : geometry.blocks) {
    unit.process(*block);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block->lanes); ++lane) {
      const SetupTriangle& t = *block->triangles[static_cast<std::size_t>(block->triangle[lane])];
      const glm::uvec3 corners = scene.objects[0].mesh->triangles[t.source];
      const auto vertex = [&](int c) { return scene.objects[0].mesh->vertices[corners[c]]; };
      const double w1 = block->weight1[lane], w2 = block->weight2[lane], w0 = 1 - w1 - w2;
      const glm::dvec3 position = w0 * vertex(0).position + w1 * vertex(1).position + w2 * vertex(2).position;
      REQUIRE(plane(*block, "probe.P.x")[lane] == Approx(position.x).margin(1e-12));
      REQUIRE(plane(*block, "probe.P.y")[lane] == Approx(position.y).margin(1e-12));
      REQUIRE(plane(*block, "n.z")[lane] ==
              Approx(w0 * vertex(0).normal.z + w1 * vertex(1).normal.z + w2 * vertex(2).normal.z).margin(1e-12));
      REQUIRE(plane(*block, "flat")[lane] == Approx(0.5 * vertex(0).normal.y).margin(1e-12));
      ++fragments;
    }
  }
  CHECK(fragments > 500);
  CHECK(unit.conversions() == 0);
}

TEST_CASE("an angle travels the short way round and stays in half a turn") {
  const Scene scene = samples::scene({samples::object(samples::plane(1))});
  const auto context = samples::context(scene);
  std::size_t turn = 0;
  while (context->attributes[turn].kind != InterpolantKind::angle) ++turn;
  auto block = samples::pool(*context)->take();
  auto triangle = std::make_shared<SetupTriangle>();
  triangle->attributes.assign(3 * static_cast<std::size_t>(context->stride()), 0.0);
  // Setup has unwrapped them: 0.45 to -0.45 (that is 0.55), and 0.35.
  const double corners[3] = {0.45, 0.55, 0.35};
  for (std::size_t c = 0; c < 3; ++c) triangle->attributes[c * static_cast<std::size_t>(context->stride()) + 2 + turn] = corners[c];
  block->triangles.push_back(triangle);
  block->lanes = 100;
  for (std::size_t lane = 0; lane < 100; ++lane) {
    block->triangle[lane] = 0;
    block->weight1[lane] = static_cast<double>(lane) / 100;
    block->weight2[lane] = 0;
  }
  Interpolators(context).process(*block);
  const Lanes& angle = block->hardware[static_cast<std::size_t>(context->attributes[turn].plane)];
  for (std::size_t lane = 0; lane < 100; ++lane) {
    const double exact = 0.45 + 0.1 * static_cast<double>(lane) / 100, difference = angle[lane] - exact;
    REQUIRE((angle[lane] >= -0.5 && angle[lane] < 0.5));
    REQUIRE(std::fabs(difference - std::round(difference)) < 1e-12);
  }
}

TEST_CASE("the netlist builds two multipliers and two adders per component, and one division a fragment") {
  const Scene scene = samples::crowded_scene();
  const auto context = samples::context(scene);
  // n 3, l 3 for each of two lights, turn; the flat angle needs no arithmetic. Then u, v and 1 / w, and four products for the weights.
  CHECK(interpolator_components(*context) == 3 + 6 + 1 + 1);
  const Inventory built = count(interpolator_netlist(*context));
  CHECK(built.multipliers == 2 * (10 + 3) + 4);
  CHECK(built.adders == 2 * (10 + 3));
  CHECK(built.dividers == 1);
}

TEST_CASE("the netlist computes what the unit computes") {
  const Scene scene = samples::scene({samples::object(samples::sphere(6))});
  const auto context = samples::context(scene);
  const samples::Geometry geometry = samples::rasterize(context);
  const Netlist netlist = interpolator_netlist(*context);
  const auto evaluator = make_evaluator(netlist, Arithmetic::real);
  Interpolators unit(context);
  FragmentBlock& block = *geometry.blocks.front();
  unit.process(block);
  std::vector<Lanes> in(netlist.inputs().size()), out(netlist.outputs().size());
  std::vector<const double*> inputs;
  std::vector<double*> outputs;
  for (Lanes& lanes : in) inputs.push_back(lanes.data());
  for (Lanes& lanes : out) outputs.push_back(lanes.data());
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const SetupTriangle& t = *block.triangles[static_cast<std::size_t>(block.triangle[lane])];
    const auto stride = static_cast<std::size_t>(context->stride());
    // Screen-space weights from the perspective-correct ones: b_i is proportional to w_i / q_i.
    const double w1 = block.weight1[lane], w2 = block.weight2[lane];
    const double s0 = (1 - w1 - w2) / t.inverse_w[0], s1 = w1 / t.inverse_w[1], s2 = w2 / t.inverse_w[2];
    std::map<std::string, double> value{
        {"b1", s1 / (s0 + s1 + s2)}, {"b2", s2 / (s0 + s1 + s2)}, {"q1", t.inverse_w[1]}, {"q2", t.inverse_w[2]}};
    const auto component = [&](const std::string& name, double a0, double a1, double a2) {
      value[name + ".a0"] = a0;
      value[name + ".d1"] = a1 - a0;
      value[name + ".d2"] = a2 - a0;
    };
    component("inverse_w", t.inverse_w[0], t.inverse_w[1], t.inverse_w[2]);
    for (std::size_t a = 0; a < stride; ++a) {
      const std::string name = a == 0   ? "u"
                               : a == 1 ? "v"
                                        : context->planes.names()[static_cast<std::size_t>(context->attributes[a - 2].plane)];
      component(name, t.attributes[a], t.attributes[stride + a], t.attributes[2 * stride + a]);
    }
    for (std::size_t i = 0; i < in.size(); ++i) in[i][lane] = value.at(netlist.inputs()[i].name);
  }
  evaluator->evaluate(inputs.data(), block.lanes, outputs.data());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string& name = netlist.outputs()[i].name;
    const Lanes& expected = name == "u"   ? block.u
                            : name == "v" ? block.v
                                          : block.hardware[static_cast<std::size_t>(context->planes.index(name))];
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane)
      REQUIRE(out[i][lane] == Approx(expected[lane]).margin(1e-9));
  }
}

}  // namespace
}  // namespace bump
