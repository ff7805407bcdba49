#pragma once
// The two units of LNS: for a vector A in {L, H}, N = (phi_N, theta_N), N' = (psi, b) about the y axis, d = phi_A - phi_N, Psi = psi +
// theta_N,
//   N'.A' = sin theta_A cos d cos b sin Psi + sin theta_A sin d sin b + cos theta_A cos b cos Psi                      (LNS)
// each product as a sum of logarithms (log_reads.h). 19 adders, 6 shifters, 18 columns read, no multiplier. This project's; in no paper.
// Timing: that of the operators recorded.

#include "schemes/common/log_reads.h"
#include "schemes/common/y_pole_design.h"

namespace bump::lns {

struct LnsParameters : YPoleParameters {
  int log_bits = 12;            ///< f: fraction bits of a logarithm
  int log_whole_bits = 4;       ///< W: bits of a table's logarithm before the point
  int antilog_table_bits = 10;  ///< m: address bits of the antilogarithm's table

  LogWidths logs() const { return {input_angle(), table_bits, log_bits, antilog_table_bits, word_bits, log_whole_bits, ports}; }
};

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs logarithms "L.G", "L.K", "L.z", those of H, "N.x", "N.y",
/// "N.z".
Netlist environment_unit(const LnsParameters& p);
/// Nodes "N_L.dot", "N_H.dot"; output "intensity".
Netlist illumination_unit(const LnsParameters& p, const Material& material);

}  // namespace bump::lns
