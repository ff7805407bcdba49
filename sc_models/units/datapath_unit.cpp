#include "units/datapath_unit.h"

#include "datapath/invariant.h"

namespace bump {

DatapathUnit::DatapathUnit(std::shared_ptr<const PipelineContext> context, Select select, bool mark)
    : context_(std::move(context)) {
  const Netlist* first = select(context_->designs.front());
  if (first == nullptr) return;
  for (const Design& design : context_->designs) {
    hardware_.push_back(make_evaluator(*select(design), context_->options.arithmetic));
    if (context_->separate_exact()) exact_.push_back(make_evaluator(*select(design), Arithmetic::real));
  }
  for (int light = 0; light < context_->passes; ++light) {
    Ports ports;
    for (const Netlist::Port& port : first->inputs()) ports.inputs.push_back(context_->plane(port.name, light));
    for (const Netlist::Port& port : first->outputs()) ports.outputs.push_back(context_->plane(port.name, light));
    ports_.push_back(std::move(ports));
  }
  if (mark) {
    const auto node = [&](const std::string& name) {
      const int found = first->find(name);
      BUMP_ASSERT(found >= 0);
      return found;
    };
    for (const std::string& name : context_->designs.front().jumps) jumps_.push_back(node(name));
    for (const Design::Least& least : context_->designs.front().least) least_.emplace_back(node(least.node), least.value);
  }
  inputs_.resize(first->inputs().size());
  outputs_.resize(first->outputs().size());
}

void DatapathUnit::mark_diverged(FragmentBlock& block, std::size_t design) const {
  const Evaluator &hardware = *hardware_[design], &exact = *exact_[design];
  for (int lane = 0; lane < block.lanes; ++lane) {
    bool diverged = false;
    for (const int flag : jumps_) diverged = diverged || hardware.value(flag, lane) != exact.value(flag, lane);
    for (const auto& [node, least] : least_) diverged = diverged || exact.value(node, lane) < least;
    if (diverged) block.diverged[static_cast<std::size_t>(lane)] = 1;
  }
}

void DatapathUnit::process(FragmentBlock& block) {
  if (hardware_.empty() || block.lanes == 0) return;
  const auto design = static_cast<std::size_t>(context_->design_of_object[static_cast<std::size_t>(block.object)]);
  for (const Ports& ports : ports_) {
    for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i] = block.hardware[static_cast<std::size_t>(ports.inputs[i])].data();
    for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i] = block.hardware[static_cast<std::size_t>(ports.outputs[i])].data();
    hardware_[design]->evaluate(inputs_.data(), block.lanes, outputs_.data());
    executions_ += block.lanes;
    if (exact_.empty()) continue;
    for (std::size_t i = 0; i < inputs_.size(); ++i) inputs_[i] = context_->exact_plane(block, ports.inputs[i]).data();
    for (std::size_t i = 0; i < outputs_.size(); ++i) outputs_[i] = block.exact[static_cast<std::size_t>(ports.outputs[i])].data();
    exact_[design]->evaluate(inputs_.data(), block.lanes, outputs_.data());
    mark_diverged(block, design);
  }
}

}  // namespace bump
