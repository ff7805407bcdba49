#pragma once
// Per-pixel datapaths of schemes that compute with Cartesian vectors: the transform into tangent space, the normaliser, and the
// illumination unit with its power table. Leaves out: the map, the vertex program, and which vectors there are, which are the scheme's.
// Timing: that of the operators recorded. Source: Peercy, Airey and Cabral 1997, Fig. 3 and Eq 7; illumination as Lee 2007 counts it for
// Ernst 1998.

#include <string>

#include "schemes/common/cartesian_widths.h"
#include "schemes/common/vectors.h"

namespace bump {

struct TangentFrame {
  VectorWires tangent, binormal, normal;
};

/// v times the matrix whose columns are T, B, N (Peercy 1997, Eq 7): 9 multipliers, 6 adders. `product` is the format of products and sums.
VectorWires to_tangent_space(Netlist& netlist, const std::string& name, const VectorWires& v, const TangentFrame& frame,
                             const Format& product);

/// L and H per pixel: inputs "N", "T", "B", "L", "H" in the format widths.component(), results "L_ts", "H_ts" in widths.product(). 18
/// multipliers, 12 adders.
struct TangentSpaceVectors {
  VectorWires light, half;
};
TangentSpaceVectors transform_pixel(Netlist& netlist, const CartesianWidths& widths);

/// v / |v| for |v| < 2^length_bits: 3 multipliers, 2 adders, 1 square root, 3 dividers. A zero vector stays zero: the divisor is raised to
/// one unit of the last place. With widths.divider off, normalise_by_table(): |v|^2 < 2 then.
VectorWires normalise_pixel(Netlist& netlist, const std::string& name, const VectorWires& v, const CartesianWidths& widths,
                            int length_bits = 1);

/// kd max(0, N'.L) + ks max(0, N'.H)^n from unit vectors: 7 multipliers, 5 adders, 1 table, of which the dot products take 6 and 4. ks is
/// folded into the table. Inputs "N_unit", "L_unit", "H_unit" in the format widths.unit(), output "intensity".
Netlist vector_illumination_unit(const CartesianWidths& widths, const Material& material);

}  // namespace bump
