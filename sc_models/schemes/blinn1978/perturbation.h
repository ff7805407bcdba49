#pragma once
// Blinn's perturbation as hardware: N' = N + Bu (N x Pv) - Bv (N x Pu) per pixel in object space, then three normalisers. The perturbation
// takes 18 multipliers and 12 adders as the equation is written, 12 and 9 with the common factor N taken out; the normalisers 9, 6, 9
// dividers, 3 square roots. Leaves out the differences of heights, as the map holds slopes. Timing: that of the operators recorded.
// Source: Blinn, SIGGRAPH 1978; Eq 1 of Lee 2007; Eqs 1-2 of Peercy, Airey and Cabral 1997.

#include "schemes/common/cartesian_widths.h"
#include "schemes/common/slope_map.h"

namespace bump::blinn1978 {

struct BlinnParameters {
  bool factored = false;  ///< N x (Bu Pv - Bv Pu) instead of two cross products
  CartesianWidths widths;
  SlopeWidths slopes;
};

/// Fills design.vertex and design.interpolants: N, Pu, Pv, L, H.
void record_vertex_program(Design& design);

/// Inputs "N", "Pu", "Pv", "L", "H", "map.u", "map.v"; outputs "L_unit", "H_unit", "N_unit": unit vectors in object space.
Netlist environment_unit(const BlinnParameters& p);

}  // namespace bump::blinn1978
