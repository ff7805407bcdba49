#pragma once
// The fast check of an emitted unit: a C++ program around the model that Verilator makes of it. It does what the test bench does
// (test_bench.h), some hundred times faster, for a million vectors and more. One text serves every unit; what differs, the ports, is in a
// header of its own.

#include <string>

#include "rtl/unit_module.h"

namespace bump {

/// "test/harness.cpp". Compiled with -DUNIT_PORTS=<unit>_ports.h, with Verilator's --prefix Vunit, and with -DUNIT_CAPACITY=<n> if the
/// model was made with -GCAPACITY=<n>. Run as: check FILE [VECTORS [SEED]]; exit code 0 only if nothing differed.
std::string harness_text();

/// "test/<unit>_ports.h".
std::string harness_ports(const RtlUnit& unit);

}  // namespace bump
