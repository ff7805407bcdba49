#pragma once
// The environment unit of an exact rotation on polar vectors: product by product what Lee 2007, section 4.1, approximates. Takes L and H
// from object space to the reference space of N by Ry(-theta_N) Rz(-phi_N), in Cartesian components between one polar pair and the next.
// 7 multipliers, 3 adders, 6 tables a vector, of which the sine and cosine of theta_N is read once for both. Reconstruction: no paper
// draws it; it is the least that multiplying out the two rotations takes. Timing: that of the operators recorded.

#include "datapath/netlist.h"
#include "schemes/common/polar_rotation.h"

namespace bump::exact_polar {

/// Inputs N, L, H as "N.phi", "N.theta" ... in input_angle(); outputs "L_ref.phi", "L_ref.theta", "H_ref.phi", "H_ref.theta" in
/// inner_angle(). Node names of a vector, after "L." or "H.": d, s (= sin theta_A cos d), y_prime, x_prime, z_prime, phi_ref.angle,
/// theta_ref.angle.
Netlist environment_unit(const RotationParameters& p);

}  // namespace bump::exact_polar
