#pragma once
// The environment unit of N3: with N' = (psi, b) about the y axis, Psi = psi + theta_N, P = Psi + b, M = Psi - b,
//   a = cos b sin Psi = (sin P + sin M)/2,  s = sin b,  c = cos b cos Psi = (cos P + cos M)/2
// is N' in the object's polar frame, and theta* = acos c, phi* = atan2(s, a) + phi_N are its polar angles. 1 multiplier, 7 adders, 6
// tables. L and H stay as they are. This project's; in no paper. Timing: that of the operators recorded.

#include "schemes/common/object_angles_unit.h"

namespace bump::n3 {

/// Inputs "N.phi", "N.theta" and the map's in input_angle(); outputs "N_object.phi", "N_object.theta" in inner_angle().
Netlist environment_unit(const ObjectAnglesParameters& p);

}  // namespace bump::n3
