#pragma once
// The datapaths of Peercy, Airey and Cabral 1997, Fig. 3: three normalisers and two dot products behind interpolators, with the transform
// of L and H into tangent space (Eq 7) at the vertices or per pixel. 9 multipliers, 6 adders, 9 dividers, 3 square roots for the
// normalisers, 18 and 12 for the transform: the 27, 18, 9, 3 of Lee 2007, Table 1. Illumination as Lee 2007 counts it for Ernst 1998: 7
// multipliers, 5 adders, 1 table. Leaves out Phong mode (a multiplexer) and ambient light. Timing: that of the operators recorded.

#include "schemes/peercy1997/peercy_parameters.h"
#include "schemes/scheme.h"

namespace bump::peercy1997 {

/// Fills design.vertex and design.interpolants.
void record_vertex_program(const PeercyParameters& p, Design& design);

/// Outputs "L_unit", "H_unit", "N_unit": unit vectors in tangent space.
Netlist environment_unit(const PeercyParameters& p);

/// Output "intensity".
Netlist illumination_unit(const PeercyParameters& p, const Material& material);

}  // namespace bump::peercy1997
