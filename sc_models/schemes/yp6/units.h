#pragma once
// The environment unit of YP6: for a vector A in {L, H}, N = (phi_N, theta_N) and N' = (psi, b) about the y axis,
//   N'.A' = G a + K s + z c                                                                                    (YP6)
// with G, K, z of A and a, s, c of N' by sums of angles (sums_projection.h); a, s, c serve both vectors. No division, no inverse function,
// no singularity. 15 adders, 9 tables of 15 columns; the illumination unit adds 6 multipliers, 4 adders. This project's; in no paper.
// Timing: that of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::yp6 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs
/// "L_turned.G", "L_turned.K", "L_turned.z", those of H, "N_turned.a", "N_turned.s", "N_turned.c".
Netlist environment_unit(const YPoleParameters& p);

}  // namespace bump::yp6
