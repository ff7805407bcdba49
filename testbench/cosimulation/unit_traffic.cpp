#include "testbench/cosimulation/unit_traffic.h"

#include <fmt/core.h>

#include <algorithm>

#include "datapath/invariant.h"

namespace bump {

namespace {

std::uint64_t low_bits(std::int64_t word, int width) {
  return static_cast<std::uint64_t>(word) & (~std::uint64_t{0} >> (64 - width));
}

template <class Ports>
bool same_ports(const Ports& ports, const std::vector<RtlPins::Port>& pins) {
  return std::equal(ports.begin(), ports.end(), pins.begin(), pins.end(),
                    [](const auto& port, const RtlPins::Port& pin) { return port.name == pin.name && port.format.width == pin.width; });
}

}  // namespace

UnitTraffic::UnitTraffic(const Netlist& netlist, const PipelineContext& context, UnitTraffic* before) : before_(before) {
  const auto port_of = [&](const Netlist::Port& port) {
    return Port{port.name, netlist.nodes()[static_cast<std::size_t>(port.node)].format, context.plane(port.name, 0), -1};
  };
  for (const Netlist::Port& port : netlist.inputs()) operand_ports_.push_back(port_of(port));
  for (const Netlist::Port& port : netlist.outputs()) result_ports_.push_back(port_of(port));
  driven_.resize(operand_ports_.size());
  values_.resize(result_ports_.size());
  if (before_ == nullptr) return;
  for (Port& port : operand_ports_) {
    const std::vector<Port>& results = before_->result_ports_;
    const auto found = std::find_if(results.begin(), results.end(), [&](const Port& result) { return result.plane == port.plane; });
    if (found == results.end()) continue;
    port.result_before = static_cast<int>(found - results.begin());
    before_->handed_on_ = true;
  }
}

void UnitTraffic::check_ports(const std::string& unit, const RtlPins& pins) const {
  if (same_ports(operand_ports_, pins.operands()) && same_ports(result_ports_, pins.results())) return;
  throw Error({"the translated " + unit + " unit has other ports than this configuration",
               {},
               "it was emitted for another scheme or other widths",
               "the same scheme and --set for both, as scripts/cosimulate.sh does"});
}

void UnitTraffic::add(const FragmentBlock& block) {
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(block.lanes); ++lane) {
    const auto word = [&](const Port& port) { return quantise(block.hardware[static_cast<std::size_t>(port.plane)][lane], port.format); };
    for (const Port& port : operand_ports_) operands_.push_back(word(port));
    for (const Port& port : result_ports_) model_.push_back(word(port));
    pixels_.push_back({block.x[lane], block.y[lane]});
  }
}

std::int64_t UnitTraffic::word_from_before(const Port& port) const {
  const auto index = static_cast<std::size_t>(port.result_before);
  BUMP_ASSERT(index < before_->out_.size());
  return quantise(to_double(before_->out_[index], before_->result_ports_[index].format), port.format);
}

const std::uint64_t* UnitTraffic::operands() {
  BUMP_ASSERT(operands_.size() >= operand_ports_.size());
  for (std::size_t i = 0; i < operand_ports_.size(); ++i) {
    const Port& port = operand_ports_[i];
    driven_[i] = low_bits(port.result_before < 0 ? operands_[i] : word_from_before(port), port.format.width);
  }
  return driven_.data();
}

void UnitTraffic::started() {
  operands_.erase(operands_.begin(), operands_.begin() + static_cast<std::ptrdiff_t>(operand_ports_.size()));
  if (before_ == nullptr || !before_->handed_on_) return;
  std::deque<std::int64_t>& taken = before_->out_;
  taken.erase(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(before_->result_ports_.size()));
}

void UnitTraffic::delivered(const std::uint64_t* results) {
  BUMP_ASSERT(model_.size() >= result_ports_.size());
  for (std::size_t i = 0; i < result_ports_.size(); ++i) {
    const Port& port = result_ports_[i];
    const std::int64_t word = wrap(static_cast<std::int64_t>(results[i]), port.format);
    const std::int64_t model = model_.front();
    model_.pop_front();
    ++report_.words;
    if (word != model && report_.different++ == 0)
      report_.first = fmt::format("{} of pixel ({}, {}) is {} instead of {}", port.name, pixels_.front().x, pixels_.front().y, word, model);
    if (handed_on_) out_.push_back(word);
    values_[i] = to_double(word, port.format);
  }
  pixels_.pop_front();
  if (listener_) listener_(values_.data());
}

}  // namespace bump
