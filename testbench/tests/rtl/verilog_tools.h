#pragma once
// Runs emitted modules under Icarus Verilog on vectors, a new operand every clock, and under Verilator's lint. A machine without the tools
// skips what needs them. For tests only.

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "datapath/format.h"
#include "rtl/verilog.h"

namespace bump_test {

/// Whether `tool` can be started; warns that the test is skipped if not.
bool is_there(const std::string& tool);

/// What `verilator --lint-only -Wall` says of the modules, each a file of its name; empty if nothing.
std::string lint(const std::vector<bump::VerilogModule>& modules);

/// Words of one cycle, one a port, two's complement in the low bits.
using PortWords = std::vector<std::int64_t>;

struct Port {
  std::string name;
  bump::Format format;
};

/// A module, what goes into it and what must come out.
struct Device {
  std::string name;  ///< of the module
  std::vector<Port> inputs, outputs;
  int stages = 0;  ///< cycles from operands to result
  std::vector<PortWords> vectors, expected;
};

/// Several devices in one simulation.
class IcarusBench {
 public:
  IcarusBench();
  ~IcarusBench();
  IcarusBench(const IcarusBench&) = delete;
  IcarusBench& operator=(const IcarusBench&) = delete;

  /// A module or a file that a module reads; the same twice is taken once.
  void add(const bump::VerilogModule& module);
  void add_file(const std::string& path, const std::string& text);
  void add(Device device) { devices_.push_back(std::move(device)); }

  /// Runs all vectors of all devices; an empty string if every word is as expected, else the first few that are not, or what the tool said.
  std::string mismatches();

  const std::vector<bump::VerilogModule>& modules() const { return modules_; }

 private:
  std::filesystem::path folder_;
  std::vector<bump::VerilogModule> modules_;
  std::vector<Device> devices_;
};

/// Words for ports of these formats: every combination if there are at most `most`, else combinations of corner words (0, 1, -1, extremes,
/// single bits) and of words spread evenly over all sizes, `most` in all.
std::vector<PortWords> words_for(const std::vector<Port>& ports, std::size_t most, std::mt19937_64& random);

/// Uniform in [low, high].
int integer(std::mt19937_64& random, int low, int high);

}  // namespace bump_test
