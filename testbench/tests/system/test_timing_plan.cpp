// The timing attributes that netlists and configuration give the pipeline.

#include <catch2/catch.hpp>

#include "system/pipeline_timing.h"
#include "system/simulation.h"
#include "units/colour_unit.h"

using namespace bump;

namespace {

Scene one_light() {
  Scene scene;
  scene.lights.emplace_back();
  scene.objects.emplace_back();
  return scene;
}

struct Plan {
  Design design;
  DatapathSchedules schedules;
  PipelineTiming timing;
};

Plan plan(const Configuration& configuration, const std::string& scheme, int lights) {
  Plan result;
  result.design = find_scheme(scheme).design(configuration, Material{});
  const Netlist colour = colour_netlist(one_light(), Material{}, ColourUnitConfig(configuration));
  result.schedules = make_schedules(result.design, colour, configuration);
  result.timing = make_pipeline_timing(result.schedules, lights, configuration);
  return result;
}

}  // namespace

TEST_CASE("datapath stages take their latency and interval from the schedule of their netlist") {
  const Configuration configuration(all_parameters());
  for (const Scheme* scheme : all_schemes()) {
    const Plan p = plan(configuration, scheme->page().id, 1);
    INFO(scheme->page().id);
    CHECK(p.timing.at(stage::environment).latency == std::max(1, p.schedules.environment.latency));
    CHECK(p.timing.at(stage::illumination).latency == p.schedules.illumination.latency + p.schedules.colour.latency);
    CHECK(p.timing.interval[stage::environment] == 1);
    CHECK(p.timing.at(stage::environment).capacity == p.timing.at(stage::environment).latency + 1);
  }
}

TEST_CASE("a limit on multipliers lengthens the interval to the products over the multipliers, rounded up") {
  for (const int limit : {1, 2, 4, 5, 6, 100}) {
    Configuration configuration(all_parameters());
    configuration.set("environment.multipliers", std::int64_t{limit}, {"test", 0, 0});
    const Plan p = plan(configuration, "lee2007", 1);
    const int products = count(p.design.environment).multipliers;
    INFO(limit);
    CHECK(p.timing.interval[stage::environment] == static_cast<std::uint32_t>((products + limit - 1) / limit));
    CHECK(p.schedules.environment.multipliers_built <= limit);
  }
}

TEST_CASE("every further light adds one initiation interval to latency and interval") {
  const Configuration configuration(all_parameters());
  const Plan one = plan(configuration, "peercy1997", 1), three = plan(configuration, "peercy1997", 3);
  CHECK(three.timing.interval[stage::environment] == 3 * one.timing.interval[stage::environment]);
  CHECK(three.timing.at(stage::environment).latency == one.timing.at(stage::environment).latency + 2);
  CHECK(three.timing.interval[stage::frame_sink] == 1);
}

TEST_CASE("a FIFO has its own depth or the common one") {
  Configuration configuration(all_parameters());
  configuration.set("fifos.depth", std::int64_t{7}, {"test", 0, 0});
  configuration.set("fifos.environment_to_illumination", std::int64_t{3}, {"test", 0, 0});
  const Plan p = plan(configuration, "lee2007", 1);
  for (const FifoSpec& fifo : p.timing.graph.fifos) CHECK(fifo.depth == (fifo.name == "environment_to_illumination" ? 3 : 7));
}

TEST_CASE("every parameter's default lies in its own range") {
  const Parameters parameters = all_parameters();
  CHECK(parameters.all().size() > 50);
  for (const auto& [key, parameter] : parameters.all()) {
    INFO(key);
    Configuration configuration(parameters);
    CHECK_NOTHROW(configuration.set(key, parameter.fallback, {"test", 0, 0}));
    CHECK_FALSE(parameter.meaning.empty());
  }
}
