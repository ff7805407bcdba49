#include "model_pins.h"

namespace bump_test {

using namespace bump;

ModelPins::ModelPins(const Netlist& netlist, const Timing& timing, Fault fault)
    : netlist_(netlist), timing_(timing), fault_(fault), evaluator_(make_evaluator(netlist_, Arithmetic::fixed)) {}

std::vector<RtlPins::Port> ModelPins::ports(const std::vector<Netlist::Port>& of) const {
  std::vector<Port> all;
  for (const Netlist::Port& port : of) all.push_back({port.name, format(port).width});
  return all;
}

bool ModelPins::in_ready() const {
  if (fault_ == Fault::stuck && taken_ == 100) return false;
  return fault_ == Fault::early || (cycle_ >= free_ && static_cast<std::int64_t>(flights_.size()) < timing_.capacity);
}

void ModelPins::drive_clock(bool level) {
  const bool rises = level && !clock_;
  clock_ = level;
  if (!rises) return;
  const bool take = in_valid_ && in_ready(), give = out_ready_ && out_valid();
  if (give) flights_.pop_front();
  if (take) {
    flights_.push_back({cycle_ + timing_.latency + (fault_ == Fault::late ? 1 : 0), evaluate()});
    if (fault_ == Fault::wrong_bit && taken_ == 99) flights_.back().results.front() ^= 1;
    free_ = cycle_ + timing_.interval;
    ++taken_;
  }
  ++cycle_;
  if (!reset_) return;
  flights_.clear();
  cycle_ = free_ = taken_ = 0;
}

std::vector<std::uint64_t> ModelPins::evaluate() {
  std::vector<double> in, out(netlist_.outputs().size());
  for (std::size_t i = 0; i < operands_.size(); ++i) {
    const Format& word = format(netlist_.inputs()[i]);
    in.push_back(to_double(wrap(static_cast<std::int64_t>(operands_[i]), word), word));
  }
  std::vector<const double*> from;
  std::vector<double*> to;
  for (const double& value : in) from.push_back(&value);
  for (double& value : out) to.push_back(&value);
  evaluator_->evaluate(from.data(), 1, to.data());
  std::vector<std::uint64_t> words;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Format& word = format(netlist_.outputs()[i]);
    words.push_back(static_cast<std::uint64_t>(quantise(out[i], word)) & (~std::uint64_t{0} >> (64 - word.width)));
  }
  return words;
}

void ModelPins::read_results(std::uint64_t* words) const {
  for (const std::uint64_t word : flights_.front().results) *words++ = word;
}

}  // namespace bump_test
