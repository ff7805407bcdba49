#pragma once
// The units of CART: L and H stay the vectors they are, and N', a vector too, is rotated once, out of the frame of N into the axes in which
// they are given; then two dot products. With N' = (x, y, z) along (e_theta, e_phi, N):
//   Ry(theta_N):   x1 = x cos theta_N + z sin theta_N,   z1 = z cos theta_N - x sin theta_N
//   Rz(phi_N):     X = x1 cos phi_N - y sin phi_N,       Y = x1 sin phi_N + y cos phi_N,      Z = z1
// 8 multipliers, 4 adders, 2 tables of 4 columns. With a texel of angles (its pole on y) x1, y, z1 are sums of sines (sums_projection.h),
// which leaves 4 multipliers, 7 adders, 4 tables of 7 columns, and the texel has unit length however it was filtered. With T, B, N
// interpolated as vectors and N' = (x, y, z) along them, x T + y B + z N costs 9 multipliers and 6 adders, no table, and serves any chart.
// The illumination unit adds 6 multipliers, 5 adders, 2 tables. The map holds -z, so the last terms have the other sign. This project's; in
// no paper. Timing: that of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::cart {

enum class NormalFrom { angles, matrix };

struct CartParameters : YPoleParameters {
  NormalFrom normal = NormalFrom::angles;
  /// Of an interpolated component of L and H, and of T, B, N.
  Format vector() const { return sfixed(word_bits + 1, word_bits); }
};

/// Inputs the map's (p.texel says which), and "N.phi", "N.theta" in input_angle(), or "T.x" ... "B.x" ... "N.z". Outputs "N_os.x",
/// "N_os.y", "N_os.minus_z" in product(); "N_os.z" for texels of angles.
Netlist environment_unit(const CartParameters& p);

/// N'.L, N'.H and the light tables from "L", "H" and the outputs above.
Netlist illumination_unit(const CartParameters& p, const Material& material);

}  // namespace bump::cart
