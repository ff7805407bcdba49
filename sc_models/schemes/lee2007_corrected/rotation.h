#pragma once
// The vector rotation of Lee 2007, section 4.1, made right by the paper's own means (sums of angles, tables, one quotient an angle), with
// neither of its two approximations. 2 multipliers, 10 adders, 11 tables a vector. Per vector A, d = phi_A - phi_N:
//   G = sin theta_A cos d, K = sin theta_A sin d      as Eqs 6-9, by sums of angles
//   psi = atan2(G, cos theta_A), b = asin K           longitude and latitude of A about the y axis; the paper takes asin G for psi
//   Z = psi - theta_N                                 the second rotation, about y, is this one subtraction
//   cos theta' = (cos(Z + b) + cos(Z - b)) / 2        instead of the linear Eq 16
//   phi' = atan2(K, (sin(Z + b) + sin(Z - b)) / 2)    instead of Eq 9
// This project's; in no paper. Timing: that of the operators recorded.

#include "datapath/netlist.h"
#include "schemes/common/polar_rotation.h"

namespace bump::lee2007_corrected {

/// Inputs N, L, H as "N.phi", "N.theta" ... in input_angle(); outputs "L_ref.phi", "L_ref.theta", "H_ref.phi", "H_ref.theta" in
/// inner_angle(). Node names of a vector, after "L." or "H.": d, X, Y, G, K, psi.angle, b, Z, x_prime, z_prime, phi_ref.angle,
/// theta_ref.angle.
Netlist environment_unit(const RotationParameters& p);

}  // namespace bump::lee2007_corrected
