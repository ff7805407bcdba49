#pragma once
// The datapaths of Peercy, Airey and Cabral 1997, Fig. 3: three normalisers and two dot products behind interpolators, with the transform
// of L and H into tangent space (Eq 7) at the vertices or per pixel. 9 multipliers, 6 adders, 9 dividers, 3 square roots for the
// normalisers, 18 and 12 for the transform: the 27, 18, 9, 3 of Lee 2007, Table 1. With a map in object space (section 2.1) L and H stay
// where the vertex program finds them, and nothing is transformed. Illumination is vector_illumination_unit(). Leaves out Phong mode (a
// multiplexer) and ambient light. Timing: that of the operators recorded.

#include "schemes/common/cartesian_units.h"
#include "schemes/peercy1997/peercy_parameters.h"
#include "schemes/scheme.h"

namespace bump::peercy1997 {

/// Fills design.vertex and design.interpolants.
void record_vertex_program(const PeercyParameters& p, Design& design);

/// Outputs "L_unit", "H_unit", "N_unit": unit vectors in the map's space, as vector_illumination_unit() takes them.
Netlist environment_unit(const PeercyParameters& p);

}  // namespace bump::peercy1997
