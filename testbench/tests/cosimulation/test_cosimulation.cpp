// Units behind pins in the pipeline: a right one changes nothing, a wrong one is noticed. Each case is a simulation of its own.

#include <algorithm>
#include <catch2/catch.hpp>

#include "channels/timeline.h"
#include "model_pins.h"
#include "system/simulation.h"
#include "system/timing_feed.h"
#include "testbench/cosimulation/cosimulation.h"
#include "testbench/program/configure.h"
#include "testbench/scene/scene_file.h"

using namespace bump;
using namespace bump_test;
using Catch::Contains;

namespace {

const std::vector<std::string> both = {"environment", "illumination"};

Scene small_world() {
  Scene scene = read_scene(std::string(BUMP_SOURCE_DIR) + "/scenes/world_sphere.toml");
  scene.width = scene.height = 48;
  return scene;
}

/// Keeps what the models have drawn.
class Watched : public Cosimulation {
 public:
  Watched(const Configuration& configuration, const std::vector<std::string>& units, Fault fault)
      : Cosimulation(configuration, units, [this, fault](const std::string& unit) { return make(unit, fault); }) {}

  void prepare(std::shared_ptr<const PipelineContext> context, const PipelineTiming& timing) override {
    context_ = context;
    timing_ = timing;
    Cosimulation::prepare(context, timing);
  }
  void draw(FrameBuffer& frame) override {
    models_ = frame;
    Cosimulation::draw(frame);
  }
  const PipelineTiming& timing() const { return timing_; }
  const FrameBuffer& models() const { return models_; }

 private:
  std::unique_ptr<RtlPins> make(const std::string& unit, Fault fault) {
    const bool first = unit == "environment";
    const Design& design = context_->designs.front();
    const auto kind = first ? stage::environment : stage::illumination;
    const StageSpec& spec = timing_.at(kind);
    const ModelPins::Timing timing{spec.latency, timing_.interval[static_cast<std::size_t>(kind)], spec.capacity};
    return std::make_unique<ModelPins>(first ? design.environment : design.illumination, timing, first ? fault : Fault::none);
  }
  std::shared_ptr<const PipelineContext> context_;
  PipelineTiming timing_;
  FrameBuffer models_;
};

struct Run {
  SimulationResult result;
  TimingResult models;  ///< of the same tokens
  FrameBuffer picture;  ///< of the models
  std::vector<UnitReport> reports;
};

/// `fault` is the environment unit's.
Run run(const std::string& scheme, const std::vector<std::string>& settings, Fault fault = Fault::none,
        const std::vector<std::string>& units = both) {
  const Scene scene = small_world();
  const Configuration configuration = configure({}, settings);
  Watched hardware(configuration, units, fault);
  std::vector<TimingRecords> records;
  SimulationOptions options;
  options.engine = Engine::stepped;
  options.measure = false;
  options.stand_in = &hardware;
  options.record = [&records](const TimingRecords& block) { records.push_back(block); };
  Run run;
  run.result = simulate(scene, find_scheme(scheme), configuration, options);
  Timeline timeline(hardware.timing().graph);
  std::vector<Cycle> intervals(hardware.timing().graph.stages.size());
  for (const TimingRecords& block : records) feed(timeline, block, hardware.timing(), intervals);
  run.models = timeline.finish();
  run.picture = hardware.models();
  run.reports = hardware.reports();
  return run;
}

void nothing_differs(const Run& run, std::size_t units = 2) {
  REQUIRE(run.reports.size() == units);
  for (const UnitReport& unit : run.reports) {
    CAPTURE(unit.unit, unit.handshake.first, unit.words.first);
    CHECK(unit.agrees());
    CHECK(unit.handshake.tokens == run.result.fragments);
    CHECK(unit.words.words >= run.result.fragments);
  }
  CHECK(run.result.fragments > 1000);
  CHECK(run.result.timing == run.models);
  CHECK(run.result.hardware.colour == run.picture.colour);
  CHECK(run.result.hardware.object == run.picture.object);
  CHECK(run.result.hardware.depth == run.picture.depth);
}

}  // namespace

TEST_CASE("units behind pins leave cycles, statistics and picture as they are") {
  nothing_differs(run("lee2007", {}));
}

TEST_CASE("units with shared multipliers between FIFOs of one slot do so, too") {
  const Run done = run("peercy1997", {"environment.multipliers=12", "illumination.multipliers=1", "fifos.depth=1", "environment.capacity=5",
                                      "memory.latency=1", "memory.cycles_per_line=1"});
  nothing_differs(done);
  const auto& stages = done.models.stages;
  const auto environment = std::find_if(stages.begin(), stages.end(), [](const StageStatistics& s) { return s.name == "environment"; });
  REQUIRE(environment != stages.end());
  CHECK(environment->busy > environment->tokens);
  CHECK(environment->blocked_room > 0);
  CHECK(environment->blocked_output > 0);
}

TEST_CASE("fragments that meet at a pixel are sorted out by depth") {
  nothing_differs(run("lee2007", {"rasterizer.early_z=false", "triangle_setup.cull=none"}));
}

TEST_CASE("light maps may lie between the units") {
  nothing_differs(run("kugler1998", {}));
}

TEST_CASE("one unit may stand among models") {
  nothing_differs(run("lee2007", {}, Fault::none, {"environment"}), 1);
}

TEST_CASE("one wrong bit of one result is noticed, and goes on to the unit behind") {
  const Run wrong = run("peercy1997", {}, Fault::wrong_bit);
  REQUIRE(wrong.reports.size() == 2);
  CHECK(wrong.reports[0].words.different == 1);
  CHECK(wrong.reports[0].handshake.wrong_cycles == 0);
  CHECK_THAT(wrong.reports[0].words.first, Contains(" of pixel (") && Contains(" instead of "));
  CHECK(wrong.reports[1].words.different <= 1);
  CHECK((wrong.result.hardware.colour != wrong.picture.colour) == (wrong.reports[1].words.different == 1));
}

TEST_CASE("a unit that is a cycle late is noticed") {
  const Run late = run("lee2007", {}, Fault::late);
  CHECK(late.reports[0].handshake.wrong_cycles > 0);
  CHECK_THAT(late.reports[0].handshake.first, Contains("out_valid is 0 instead of 1"));
  CHECK(late.reports[0].words.different == 0);
  CHECK_FALSE(late.result.timing == late.models);
}

TEST_CASE("a unit that takes more than it may is noticed") {
  const Run early = run("peercy1997", {"environment.multipliers=1"}, Fault::early);
  CHECK(early.reports[0].handshake.wrong_cycles > 0);
  CHECK_THAT(early.reports[0].handshake.first, Contains("in_ready is 1 instead of 0"));
}

TEST_CASE("a unit that takes no more tokens ends the run with its name") {
  CHECK_THROWS_WITH(run("lee2007", {}, Fault::stuck), Contains("the Verilog of the environment unit stands still after 100 tokens"));
}

TEST_CASE("what cannot be co-simulated is refused") {
  const Scheme& lee = find_scheme("lee2007");
  const Configuration plain = configure({}, {});
  const Scene world = small_world();
  CHECK_NOTHROW(check_cosimulation(world, lee, plain));
  CHECK_THROWS_WITH(check_cosimulation(world, lee, configure({}, {"numeric=double"})), Contains("double precision"));
  Scene lights = world;
  lights.lights.push_back(lights.lights.front());
  CHECK_THROWS_WITH(check_cosimulation(lights, lee, plain), Contains("2 lights"));
  CHECK_NOTHROW(check_cosimulation(lights, find_scheme("kugler1998"), plain));
  Scene materials = world;
  materials.objects.push_back(materials.objects.front());
  CHECK_NOTHROW(check_cosimulation(materials, lee, plain));
  materials.objects.back().material.shininess += 1;
  CHECK_THROWS_WITH(check_cosimulation(materials, lee, plain), Contains("several materials"));
  materials.objects.clear();
  CHECK_THROWS_WITH(check_cosimulation(materials, lee, plain), Contains("no object"));
}
