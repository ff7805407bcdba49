// The pins of a unit that `verilator --sc` has translated, as a library that the co-simulation loads. Compiled once for every unit, with
// its ports as UNIT_PORTS (a header that `cosimulate plan` writes) and Verilator's class as Vunit.

#include <systemc>
#include <type_traits>

#include "Vunit.h"
#include "testbench/cosimulation/rtl_pins.h"
#include UNIT_PORTS

namespace {

template <class Port>
using Level = typename std::remove_reference_t<Port>::data_type;

template <class Port>
using Wire = sc_core::sc_signal<Level<Port>, sc_core::SC_MANY_WRITERS>;  // driven by the reset, then at both edges

#define CONTROL(DO) DO(clk, "", 1) DO(reset, "", 1) DO(in_valid, "", 1) DO(in_ready, "", 1) DO(out_valid, "", 1) DO(out_ready, "", 1)
#define WIRE(port, name, width) Wire<decltype(Vunit::port)> port##_{#port};
#define BIND(port, name, width) unit_.port(port##_);
#define DESCRIBE(port, name, width) {name, width},
#define DRIVE(port, name, width) port##_.write(static_cast<Level<decltype(Vunit::port)>>(*words++));
#define READ(port, name, width) *words++ = static_cast<std::uint64_t>(port##_.read());

class VerilatedUnit : public bump::RtlPins {
 public:
  VerilatedUnit() {
    CONTROL(BIND)
    UNIT_OPERANDS(BIND)
    UNIT_RESULTS(BIND)
  }
  ~VerilatedUnit() override { unit_.final(); }

  std::vector<Port> operands() const override { return {UNIT_OPERANDS(DESCRIBE)}; }
  std::vector<Port> results() const override { return {UNIT_RESULTS(DESCRIBE)}; }

  void drive_clock(bool level) override { clk_.write(level); }
  void drive_reset(bool level) override { reset_.write(level); }
  void drive_in_valid(bool level) override { in_valid_.write(level); }
  void drive_operands(const std::uint64_t* words) override { UNIT_OPERANDS(DRIVE) }
  void drive_out_ready(bool level) override { out_ready_.write(level); }

  bool in_ready() const override { return in_ready_.read(); }
  bool out_valid() const override { return out_valid_.read(); }
  void read_results(std::uint64_t* words) const override { UNIT_RESULTS(READ) }

 private:
  Vunit unit_{"verilated"};
  CONTROL(WIRE)
  UNIT_OPERANDS(WIRE)
  UNIT_RESULTS(WIRE)
};

}  // namespace

extern "C" void bump_make_rtl_pins(std::unique_ptr<bump::RtlPins>& pins) {
  pins = std::make_unique<VerilatedUnit>();
}
