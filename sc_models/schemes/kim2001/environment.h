#pragma once
// The environment unit of Kim, Lee and Park 2001. transform = matrix is a RECONSTRUCTION of the 31 multipliers, 18 adders and 6 tables
// that Lee 2007, Table 1, charges it, from schemes that close: L and H from polar angles to vectors (4 tables of sine and cosine, 4
// multipliers), three products with the matrix of T, B, N, of L, H and N (27 multipliers, 18 adders), and back to angles (2 arc cosines).
// The azimuths that Eqs 3-4 need besides are an addition: 2 dividers, 6 adders, 2 tables. transform = direct is the least that perturbing
// by angles takes, 2 adders in object space. Timing: that of the operators recorded.

#include "datapath/netlist.h"
#include "schemes/kim2001/kim_parameters.h"

namespace bump::kim2001 {

/// Inputs "L.phi", "L.theta", "H.phi", "H.theta" in input_angle() and the map's channels; with them "N.x" ... "T.x" ... "B.x" ... for
/// matrix, "N.phi", "N.theta" for direct. Outputs, all in inner_angle(): "L_ref.phi", "L_ref.theta", "H_ref.phi", "H_ref.theta" and N' for
/// the two dot products, "N_L.phi", "N_L.theta", "N_H.phi", "N_H.theta". For matrix also the third product, "N_ref.x" "N_ref.y" "N_ref.z".
Netlist environment_unit(const KimParameters& p);

}  // namespace bump::kim2001
