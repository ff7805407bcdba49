#pragma once
// The two units of LNSG, for any tangent frame: for a vector A in {L, H} with G, K, z turned by -phi_N (log_vector.h), N = (phi_N,
// theta_N), N' = (phi_g, theta_g) of a map about z, and ph = phi_g + alpha, the angle from e_theta to T,
//   N'.A' = G sin theta_g cos ph cos theta_N - z sin theta_g cos ph sin theta_N + K sin theta_g sin ph
//         + G cos theta_g sin theta_N + z cos theta_g cos theta_N                                                            (LNSG)
// each product as a sum of logarithms (log_reads.h). 30 adders and one that adds alpha, 10 shifters, 24 columns read, no multiplier. This
// project's; in no paper. Timing: that of the operators recorded.

#include "schemes/common/log_reads.h"
#include "schemes/common/polar_settings.h"
#include "units/scene.h"

namespace bump::lnsg {

struct LnsgParameters : PolarSettings {
  int table_bits = 10;          ///< k: address bits of a quarter turn of logarithms
  int word_bits = 12;           ///< w: bits of an antilogarithm's word
  int log_bits = 12;            ///< f: fraction bits of a logarithm
  int log_whole_bits = 4;       ///< W: bits of a table's logarithm before the point
  int antilog_table_bits = 10;  ///< m: address bits of the antilogarithm's table
  int light_table_bits = 10;    ///< address bits of the light tables
  int light_word_bits = 16;     ///< of their words
  int ports = 1;                ///< of a ROM

  LogWidths logs() const { return {input_angle(), table_bits, log_bits, antilog_table_bits, word_bits, log_whole_bits, ports}; }
};

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's, "alpha", "mirror" where the settings ask for them; outputs
/// logarithms: "L.G", "L.K", "L.z", those of H, and of N' what G, K, z are multiplied by: "N.x_cos", "N.x_sin", "N.y", "N.z_sin",
/// "N.z_cos".
Netlist environment_unit(const LnsgParameters& p);
/// Nodes "N_L.dot", "N_H.dot"; output "intensity".
Netlist illumination_unit(const LnsgParameters& p, const Material& material);

}  // namespace bump::lnsg
