#pragma once
// The vector rotation unit of Lee 2007, section 4.1 and Fig. 8: takes L and H from object space to the reference space of N, in polar
// angles, by two rotations each: -phi_N about z, -theta_N about y. 3 multipliers, 8 adders, 6 tables a vector. Fig. 8 itself is not at
// hand: the datapath is derived from Eqs 6-18 and 26-27, the operator counts of section 5.1, and the only assignment of tables under which
// they agree. The rotation is an approximation (mean 16, worst 60 degrees); parameters switch its two mistakes and the sign corrections on
// and off. Timing: that of the operators recorded; 11 operators on the longest path.

#include "datapath/netlist.h"
#include "schemes/lee2007/lee_parameters.h"

namespace bump::lee2007 {

/// The environment unit. Inputs N, L, H as "N.phi", "N.theta" ... in input_angle(); outputs "L_ref.phi", "L_ref.theta", "H_ref.phi",
/// "H_ref.theta" in inner_angle(). Node names of a vector, after "L." or "H.": d, X, Y, y (= sin theta_A sin d), theta_x, Z, y_k (its
/// magnitude before the clamp), T_prop.prop, phi_ref, theta_ref.
Netlist environment_unit(const LeeParameters& p);

}  // namespace bump::lee2007
