#pragma once
// The environment unit (the vector rotation): brings light and half vector, or the normal, into the space in which the scheme shades.
// Values by the design's environment netlist, per light; latency and initiation interval from its schedule. On request it measures the
// angular error of the directions it delivers. Source: the scheme's paper; the name is Lee 2007's "environment setup".

#include <memory>

#include "units/angular_error.h"
#include "units/datapath_unit.h"

namespace bump {

class EnvironmentUnit {
 public:
  explicit EnvironmentUnit(std::shared_ptr<const PipelineContext> context);
  void process(FragmentBlock& block);

  std::int64_t executions() const { return datapath_.executions(); }
  const AngularMeter& meter() const { return meter_; }

 private:
  DatapathUnit datapath_;
  AngularMeter meter_;
};

}  // namespace bump
