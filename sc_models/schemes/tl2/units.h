#pragma once
// The two units of TL2: with psi, b of N', L and H about the y axis of tangent space (tangent_angles.h), for A in {L, H}, u = cos(b - b_A),
// v = cos(b + b_A), hav x = (1 - cos x)/2,
//   N'.A = u - (u + v) hav(psi - psi_A)                                                                                     (TL2)
// the law of cosines of latitudes. 2 multipliers, 10 adders, 6 tables for both; 1 adder and 2 tables for the light. This project's; in no
// paper. Timing: that of the operators recorded.

#include "schemes/common/tangent_angles.h"

namespace bump::tl2 {

/// Inputs "L.psi", "L.b", "H.psi", "H.b" and the map's; outputs "L.less", "L.plus", "L.psi_less": b - b_A, b + b_A, psi - psi_A; those of
/// H.
Netlist environment_unit(const TangentAngleParameters& p);
/// Nodes "N_L.dot", "N_H.dot"; output "intensity".
Netlist illumination_unit(const TangentAngleParameters& p, const Material& material);

}  // namespace bump::tl2
