#pragma once
// Emitted units in the pipeline, in the place of the environment and of the illumination stage: handshake and words are the Verilog's, from
// the environment's results through the illumination unit to the picture. What lies between and around them (light maps, texels, colour
// unit, frame sink) is the models'. The stage `illumination` has the colour unit in it: the emitted unit takes its cycles as parameter
// TAIL. One light, or light maps, and one material: an emitted unit holds the tables of one material and takes one pass for each fragment.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "channels/parameters.h"
#include "system/stand_in.h"
#include "testbench/cosimulation/intensity_painter.h"
#include "testbench/cosimulation/rtl_stage.h"
#include "testbench/cosimulation/unit_traffic.h"

namespace bump {

/// Throws Error(input) if the scene cannot be co-simulated: several lights without light maps, several materials, double precision.
void check_cosimulation(const Scene& scene, const Scheme& scheme, const Configuration& configuration);

/// Pins of a unit, "environment" or "illumination"; null if there is none: the stage is then the model. Called while modules are built.
using PinsFactory = std::function<std::unique_ptr<RtlPins>(const std::string& unit)>;

/// What was seen of one unit.
struct UnitReport {
  std::string unit;
  HandshakeReport handshake;
  WordReport words;
  bool agrees() const { return handshake.wrong_cycles == 0 && words.different == 0; }
};

class Cosimulation : public StandIn {
 public:
  /// `units`: "environment", "illumination" or both; `make_pins` must know them.
  Cosimulation(const Configuration& configuration, std::vector<std::string> units, PinsFactory make_pins);

  void prepare(std::shared_ptr<const PipelineContext> context, const PipelineTiming& timing) override;
  std::unique_ptr<ClockedStage> stage(const StageParts& parts) override;
  void retire(const FragmentBlock& block) override;
  /// Draws only with an illumination unit; else the frame is the models'.
  void draw(FrameBuffer& frame) override;

  /// In the order of the pipeline; as long as the engine lives, after the simulation.
  std::vector<UnitReport> reports() const { return reports_; }

 private:
  struct Unit {
    std::string name;
    std::unique_ptr<UnitTraffic> traffic;
    const RtlStage* stage = nullptr;  ///< the engine's
  };
  Unit* find(const std::string& name);
  bool has(const std::string& name) const;

  const ColourUnitConfig colour_;
  const std::vector<std::string> names_;
  const PinsFactory make_pins_;
  std::vector<Unit> units_;
  std::unique_ptr<IntensityPainter> painter_;
  std::vector<UnitReport> reports_;
};

}  // namespace bump
