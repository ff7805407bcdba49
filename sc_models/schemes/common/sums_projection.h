#pragma once
// Rotations by sums of angles. The first rotation of a polar vector A, by -phi_N about z, as Lee 2007, Eqs 6-9, without its halving: with
// d = phi_A - phi_N, X = theta_A + d, Y = theta_A - d,
//   G = sin theta_A cos d = (sin X + sin Y)/2,  K = sin theta_A sin d = (cos Y - cos X)/2,  z = cos theta_A.
// The second rotation, about y, is done to N' instead, backwards: with its pole on y, Psi = psi + theta_N, P = Psi + b, M = Psi - b,
//   a = cos b sin Psi = (sin P + sin M)/2,  s = sin b,  c = cos b cos Psi = (cos P + cos M)/2,
// and N'.A' = G a + K s + z c. This project's but for the first rotation. Timing: that of the operators recorded.

#include <string>

#include "schemes/common/polar_rotation.h"
#include "schemes/common/sums_reads.h"

namespace bump {

struct PlaneWires {
  Wire d, X, Y;  ///< angles
  Wire G, K;     ///< in SineReads::half_word()
};

/// Nodes d, X, Y, SC_X, SC_Y, G, K in the scope `name`. 5 adders, 2 tables of 4 columns.
PlaneWires projected_plane(Netlist& netlist, const std::string& name, const PolarDirection& a, Wire normal_phi, SineReads& reads);

struct ProjectedWires {
  Wire G, K;  ///< in SineReads::half_word()
  Wire z;     ///< in SineReads::word()
};

/// The same and z, node COS_THETA. 5 adders, 3 tables of 5 columns.
ProjectedWires projected(Netlist& netlist, const std::string& name, const PolarDirection& a, Wire normal_phi, SineReads& reads);

/// Inputs "name.phi", "name.theta" in the index format of the reads.
PolarDirection input_polar(Netlist& netlist, const std::string& name, const SineReads& reads);

struct TurnedNormalWires {
  Wire a, c;  ///< in SineReads::half_word()
  Wire s;     ///< in SineReads::word()
};

/// Nodes Psi, P, M, SC_P, SC_M, SIN_B, a, c in the scope "N". 5 adders, 3 tables of 5 columns.
TurnedNormalWires turned_normal(Netlist& netlist, Wire psi, Wire latitude, Wire normal_theta, SineReads& reads);

}  // namespace bump
