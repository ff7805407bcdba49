#pragma once
// The units of YP2: YP6 with its products K sin b and z c taken apart into sums. For a vector A in {L, H}, with d = phi_A - phi_N,
// X = theta_A + d, Y = theta_A - d, Psi = psi + theta_N, P = Psi + b, M = Psi - b, a = (sin P + sin M)/2, G = (sin X + sin Y)/2,
//   N'.A' = G a + [ cos(theta_A + P) + cos(theta_A - P) + cos(theta_A + M) + cos(theta_A - M)
//                   + sin(b + Y) + sin(b - Y) - sin(b + X) - sin(b - X) ]/4                                            (YP2)
// 2 multipliers, 44 adders, 22 tables of one column for both vectors. This project's; in no paper. Timing: that of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::yp2 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs "L_turned.G", "L_turned.rest" (the bracket over 4), those of
/// H, "N_turned.a". 42 adders, 22 tables.
Netlist environment_unit(const YPoleParameters& p);

/// Both dot products and the light tables: 2 multipliers, 2 adders; 1 adder and 2 tables for the light.
Netlist illumination_unit(const YPoleParameters& p, const Material& material);

}  // namespace bump::yp2
