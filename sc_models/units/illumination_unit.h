#pragma once
// The illumination unit: diffuse plus specular intensity of each light by the design's illumination netlist. Latency and initiation
// interval come from its schedule. Ambient light, several lights' sum and the colour texel are the colour unit's. Source: the scheme's
// paper; Lee 2007 Eq 2.

#include <memory>

#include "units/datapath_unit.h"

namespace bump {

class IlluminationUnit {
 public:
  explicit IlluminationUnit(std::shared_ptr<const PipelineContext> context);
  void process(FragmentBlock& block);

  std::int64_t executions() const { return datapath_.executions(); }

 private:
  DatapathUnit datapath_;
};

}  // namespace bump
