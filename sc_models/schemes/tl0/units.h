#pragma once
// The two units of TL0: with psi, b of N', L and H about the y axis of tangent space (tangent_angles.h), for A in {L, H}, hav x =
// (1 - cos x)/2,
//   N'.A = cos(b - b_A) - 2 cos b cos b_A hav(psi - psi_A)                                                                  (TL0)
// the law of haversines, its product a sum of logarithms (log_reads.h). All three factors are positive, so there are no signs. No
// multiplier, 10 adders, 9 tables, 2 shifters for both; 1 adder and 2 tables for the light. This project's; in no paper. Timing: that of
// the operators recorded.

#include "schemes/common/log_reads.h"
#include "schemes/common/tangent_angles.h"

namespace bump::tl0 {

struct Tl0Parameters : TangentAngleParameters {
  int log_table_bits = 10;      ///< address bits of the logarithm of a cosine, for a quarter turn
  int log_bits = 12;            ///< f: fraction bits of a logarithm
  int log_whole_bits = 4;       ///< W: bits of the logarithm of a haversine before the point; a cosine's has one less
  int antilog_table_bits = 10;  ///< m: address bits of the antilogarithm's table

  LogWidths logs() const { return {input_angle(), log_table_bits, log_bits, antilog_table_bits, word_bits, log_whole_bits, ports}; }
};

/// Inputs "L.psi", "L.b", "H.psi", "H.b" and the map's; outputs "log_cos", that of b, and for each vector "L.less", "L.psi_less": b - b_A,
/// psi - psi_A, and "L.log_cos", that of b_A.
Netlist environment_unit(const Tl0Parameters& p);
/// Nodes "N_L.dot", "N_H.dot"; output "intensity".
Netlist illumination_unit(const Tl0Parameters& p, const Material& material);

}  // namespace bump::tl0
