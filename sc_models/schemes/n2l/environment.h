#pragma once
// The environment unit of N2L: N3 with the division in its arc tangent done by logarithms. With Psi = psi + theta_N,
//   phi* = atan2(sin b, cos b sin Psi) + phi_N,   tan = tan b / sin Psi = 2^-x,  x = log2 |sin Psi| - log2 |tan b|
//   theta* = acos((cos P + cos M)/2),   P = Psi + b, M = Psi - b
// and a table takes x to the angle, with no antilogarithm between. 8 adders, 6 tables, no multiplier. This project's; in no paper. Timing:
// that of the operators recorded.

#include "schemes/common/object_angles_unit.h"

namespace bump::n2l {

struct N2lParameters : ObjectAnglesParameters {
  int log_bits = 12;  ///< f: fraction bits of a logarithm
};

/// Inputs "N.phi", "N.theta" and the map's in input_angle(); outputs "N_object.phi", "N_object.theta" in inner_angle().
Netlist environment_unit(const N2lParameters& p);

}  // namespace bump::n2l
