#pragma once
// A polar vector A in logarithms, turned by -phi_N about z: with d = phi_A - phi_N,
//   G = sin theta_A cos d,  K = sin theta_A sin d,  z = cos theta_A
// as logarithms and signs, which pass from one unit to the next under "<name>.G.log", "<name>.G.negative" ... This project's. Timing: that
// of the operators recorded.

#include <string>

#include "schemes/common/log_reads.h"
#include "schemes/common/polar_rotation.h"

namespace bump {

struct LogVector {
  LogValue G, K, z;
};

/// Records and outputs G, K, z of A, nodes LSC_THETA, d, LSC_D, log_G, log_K in the scope `name`: 3 adders, 2 tables of 4 columns.
void output_log_vector(Netlist& netlist, const std::string& name, const PolarDirection& a, Wire normal_phi, LogReads& reads);
LogVector input_log_vector(Netlist& netlist, const std::string& name, const LogWidths& widths);

}  // namespace bump
