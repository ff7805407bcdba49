#include "units/illumination_unit.h"

namespace bump {

namespace {

const Netlist* illumination_of(const Design& design) {
  return &design.illumination;
}

}  // namespace

IlluminationUnit::IlluminationUnit(std::shared_ptr<const PipelineContext> context) : datapath_(std::move(context), illumination_of) {}

void IlluminationUnit::process(FragmentBlock& block) {
  datapath_.process(block);
}

}  // namespace bump
