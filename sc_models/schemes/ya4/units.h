#pragma once
// The units of YA4: the law of cosines about the y axis. A vector A in {L, H} gets longitude and latitude there as N' has them, from G, K,
// z (sums_projection.h): psi_A = atan2(G, z), b_A = asin K, both before the second rotation, which adds theta_N to a longitude. Then
//   N'.A' = (cos(b - b_A) - cos(b + b_A))/2 + (cos(b - b_A) + cos(b + b_A))/2 cos(Psi - psi_A),   Psi = psi + theta_N        (YA4)
// 4 multipliers (two in the arc tangents), 23 adders, 18 tables of 22 columns for both vectors. This project's; in no paper. Timing: that
// of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::ya4 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs "L_turned.psi", "L_turned.latitude", those of H,
/// "N_turned.psi"
/// (= Psi), "N_turned.latitude" in turns(word_bits + 2). 2 multipliers, 11 adders, 12 tables.
Netlist environment_unit(const YPoleParameters& p);

/// Both dot products and the light tables: 2 multipliers, 12 adders, 6 tables; 1 adder and 2 tables for the light.
Netlist illumination_unit(const YPoleParameters& p, const Material& material);

}  // namespace bump::ya4
