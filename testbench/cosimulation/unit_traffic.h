#pragma once
// The words that travel past a unit beside its tokens: operands as the functional plane has them, quantised as the evaluator does, or as
// the unit in front of it has delivered them; and results, held against those of the model. No hardware.

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "testbench/cosimulation/rtl_stage.h"
#include "units/pipeline_context.h"

namespace bump {

/// The results of a unit beside those of its model.
struct WordReport {
  std::int64_t words = 0;  ///< compared
  std::int64_t different = 0;
  std::string first;  ///< the first difference, empty if there is none
};

class UnitTraffic : public TokenWords {
 public:
  /// `before`: the unit whose results replace the model's wherever this one reads them; null: none. It must outlive this.
  UnitTraffic(const Netlist& netlist, const PipelineContext& context, UnitTraffic* before);

  /// Called with every token's results, as values, in the order of the netlist's outputs.
  void tell(std::function<void(const double* results)> listener) { listener_ = std::move(listener); }
  /// Throws Error(input) if the unit has other ports: it was translated for another configuration.
  void check_ports(const std::string& unit, const RtlPins& pins) const;
  /// The tokens of a block of fragments, before any of them starts.
  void add(const FragmentBlock& block);

  const std::uint64_t* operands() override;
  void started() override;
  void delivered(const std::uint64_t* results) override;

  const WordReport& report() const { return report_; }

 private:
  struct Port {
    std::string name;
    Format format;
    int plane;
    int result_before = -1;  ///< of the unit in front
  };
  struct Pixel {
    std::int32_t x, y;
  };
  std::int64_t word_from_before(const Port& port) const;

  std::vector<Port> operand_ports_, result_ports_;
  UnitTraffic* const before_;
  bool handed_on_ = false;                           ///< a unit behind reads the results
  std::deque<std::int64_t> operands_, model_, out_;  ///< words: of tokens not started, not delivered, not taken by the unit behind
  std::deque<Pixel> pixels_;                         ///< of tokens not delivered
  std::vector<std::uint64_t> driven_;
  std::vector<double> values_;
  std::function<void(const double*)> listener_;
  WordReport report_;
};

}  // namespace bump
