#pragma once
// The pins of an emitted unit (rtl/unit_module.h), whatever is behind them: Verilog translated to SystemC, or a model of it in a test.
// Levels that are driven reach the unit within the same instant of simulated time; what the unit shows is read one delta cycle later at the
// earliest. Words are two's complement in the low bits. Translated units are libraries of their own, which export `bump_make_rtl_pins`.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bump {

class RtlPins {
 public:
  struct Port {
    std::string name;  ///< the netlist's
    int width = 0;     ///< bits, 1 .. 64
  };
  virtual ~RtlPins() = default;

  /// In the order in which words are driven and read; the same for the whole life of the unit.
  virtual std::vector<Port> operands() const = 0;
  virtual std::vector<Port> results() const = 0;

  virtual void drive_clock(bool level) = 0;
  virtual void drive_reset(bool level) = 0;
  virtual void drive_in_valid(bool level) = 0;
  virtual void drive_operands(const std::uint64_t* words) = 0;
  virtual void drive_out_ready(bool level) = 0;

  virtual bool in_ready() const = 0;
  virtual bool out_valid() const = 0;
  virtual void read_results(std::uint64_t* words) const = 0;
};

/// What a library of a translated unit exports under the name `bump_make_rtl_pins`. To be called while modules are built.
using MakeRtlPins = void (*)(std::unique_ptr<RtlPins>& pins);

}  // namespace bump
