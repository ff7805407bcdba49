#include "units/environment_unit.h"

namespace bump {

namespace {

const Netlist* environment_of(const Design& design) {
  return &design.environment;
}

}  // namespace

EnvironmentUnit::EnvironmentUnit(std::shared_ptr<const PipelineContext> context)
    : datapath_(context, environment_of, true), meter_(context) {}

void EnvironmentUnit::process(FragmentBlock& block) {
  block.diverged.fill(0);
  datapath_.process(block);
  meter_.process(block);
}

}  // namespace bump
