#pragma once
// The units of YP0: both dot products without a multiplier. For a vector A in {L, H}, with d = phi_A - phi_N, Psi = psi + theta_N,
// u = theta_A - Psi, v = theta_A + Psi, E = d - b, F = d + b, cc(x, y) = cos(x + y) + cos(x - y), ss(x, y) = sin(x + y) + sin(x - y),
//   N'.A' = [ cc(u, E) + cc(u, F) - cc(v, E) - cc(v, F) ]/8 + [ cc(u, b) + cc(v, b) + ss(theta_A, E) - ss(theta_A, F) ]/4       (YP0)
// 73 adders, 32 tables of one column for both vectors; light tables behind. This project's; in no paper. Timing: that of the operators
// recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::yp0 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs "L_turned.dot" and that of H in dot_format().
Netlist environment_unit(const YPoleParameters& p);
/// Sums over 8 are exact.
Format dot_format(const YPoleParameters& p);

/// The light tables: 1 adder, 2 tables.
Netlist illumination_unit(const YPoleParameters& p, const Material& material);

}  // namespace bump::yp0
