#include "testbench/cosimulation/cosimulation.h"

#include <algorithm>

#include "datapath/invariant.h"
#include "testbench/scene/only_material.h"

namespace bump {

void check_cosimulation(const Scene& scene, const Scheme& scheme, const Configuration& configuration) {
  const std::string& id = scheme.page().id;
  if (configuration.choice("numeric") == "double")
    throw Error({"double precision has no hardware", configuration.entries().at("numeric").origin,
                 "Verilog is made of the fixed-point datapaths", "numeric=fixed"});
  const Material& material = only_material(scene);
  if (scene.lights.size() > 1 && !scheme.design(configuration, material).light_maps)
    throw Error({"the scene has " + std::to_string(scene.lights.size()) + " lights",
                 {},
                 "an emitted unit takes a fragment once, and " + id + " would send it once for each light",
                 "a scene with one light, or a scheme with light maps"});
}

Cosimulation::Cosimulation(const Configuration& configuration, std::vector<std::string> units, PinsFactory make_pins)
    : colour_(configuration), names_(std::move(units)), make_pins_(std::move(make_pins)) {}

bool Cosimulation::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

Cosimulation::Unit* Cosimulation::find(const std::string& name) {
  const auto found = std::find_if(units_.begin(), units_.end(), [&](const Unit& unit) { return unit.name == name; });
  return found == units_.end() ? nullptr : &*found;
}

void Cosimulation::prepare(std::shared_ptr<const PipelineContext> context, const PipelineTiming&) {
  BUMP_ASSERT(context->passes == 1 && context->designs.size() == 1 && context->options.arithmetic == Arithmetic::fixed);
  const Design& design = context->designs.front();
  UnitTraffic* before = nullptr;
  if (has("environment")) {
    units_.push_back({"environment", std::make_unique<UnitTraffic>(design.environment, *context, nullptr)});
    before = units_.back().traffic.get();
  }
  if (!has("illumination")) return;
  units_.push_back({"illumination", std::make_unique<UnitTraffic>(design.illumination, *context, before)});
  painter_ = std::make_unique<IntensityPainter>(context, colour_);
  BUMP_ASSERT(design.illumination.outputs().size() == 1);
  units_.back().traffic->tell([this](const double* results) { painter_->paint(results[0]); });
}

std::unique_ptr<ClockedStage> Cosimulation::stage(const StageParts& parts) {
  Unit* unit = find(parts.spec.name);
  if (unit == nullptr) return nullptr;
  auto stage = std::make_unique<RtlStage>(
      parts.spec.name.c_str(), parts, [&] { return make_pins_(unit->name); }, *unit->traffic);
  unit->traffic->check_ports(unit->name, stage->pins());
  unit->stage = stage.get();
  return stage;
}

void Cosimulation::retire(const FragmentBlock& block) {
  for (Unit& unit : units_) unit.traffic->add(block);
  if (painter_) painter_->add(block);
}

void Cosimulation::draw(FrameBuffer& frame) {
  for (const Unit& unit : units_) reports_.push_back({unit.name, unit.stage->handshake(), unit.traffic->report()});
  if (painter_) frame = painter_->finish();
}

}  // namespace bump
