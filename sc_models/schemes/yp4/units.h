#pragma once
// The units of YP4: for a vector A in {L, H}, with d = phi_A - phi_N, Psi = psi + theta_N, u = theta_A - Psi, v = theta_A + Psi,
//   N'.A' = [ (cos u + cos v)/2 + (cos(u + d) + cos(u - d) - cos(v + d) - cos(v - d))/4 ] cos b + K sin b        (YP4)
//   K = (cos(theta_A - d) - cos(theta_A + d))/2
// Only the latitude b is multiplied: 4 multipliers, 33 adders, 18 tables of one column for both vectors. This project's; in no paper.
// Timing: that of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::yp4 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs "L_turned.flat" (the bracket), "L_turned.K", those of H,
/// "N_turned.cos_b", "N_turned.sin_b". 31 adders, 18 tables.
Netlist environment_unit(const YPoleParameters& p);

/// Both dot products and the light tables: 4 multipliers, 2 adders; 1 adder and 2 tables for the light.
Netlist illumination_unit(const YPoleParameters& p, const Material& material);

}  // namespace bump::yp4
