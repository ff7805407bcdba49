#pragma once
// Three-component vectors recorded as netlist nodes: ports, dot products, normalisers and the half vector. Pieces that several schemes
// share; each adds exactly the operators that its docstring counts. Vertex programs use `real` formats throughout, per-pixel units fixed
// point. Leaves out: any choice of word width, which is the scheme's. Timing: that of the operators recorded.

#include <string>

#include "datapath/netlist.h"

namespace bump {

struct VectorWires {
  Wire x, y, z;
};

/// Ports "name.x", "name.y", "name.z".
VectorWires input_vector(Netlist& netlist, const std::string& name, const Format& format);
void output_vector(Netlist& netlist, const std::string& name, const VectorWires& vector);

/// a.x b.x + a.y b.y + a.z b.z: 3 multipliers, 2 adders. `product` and `sum` are the formats of the products and of both sums.
Wire dot_product(Netlist& netlist, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& product,
                 const Format& sum, const std::string& equation = "");

/// a x b: 6 multipliers, 3 adders.
VectorWires cross_product(Netlist& netlist, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& product,
                          const Format& difference, const std::string& equation = "");

/// Component by component: 3 adders.
VectorWires sum_of_vectors(Netlist& netlist, const std::string& name, const VectorWires& a, const VectorWires& b, const Format& format);

/// Formats of a normaliser. Components of the result are in [-1, 1] up to rounding, so `quotient` needs a bit for 1 itself.
struct NormaliserFormats {
  Format square;    ///< unsigned: squares
  Format sum;       ///< unsigned: sums of squares
  Format length;    ///< unsigned: the root
  Format quotient;  ///< signed: the result's components
};

/// v / |v| with one square root and three dividers: 3 multipliers, 2 adders, 1 square root, 3 dividers. `shortest` > 0 is what the divisor
/// is raised to, by a clamp, so that a zero vector stays zero.
VectorWires normalise(Netlist& netlist, const std::string& name, const VectorWires& v, const NormaliserFormats& formats, double shortest);

/// v / |v| by a table of 1/sqrt(x) over the squared length, for 1/128 <= |v|^2 < 2: 6 multipliers, 2 adders, 1 table with a floating index
/// of 3 exponent bits. `words` is the width of its words; `address_bits` includes the exponent.
VectorWires normalise_by_table(Netlist& netlist, const std::string& name, const VectorWires& v, const NormaliserFormats& formats,
                               int address_bits, int words);

/// v / |v| in a vertex program (`real`): 3 multipliers, 2 adders, 1 square root, 3 dividers. A zero vector stays zero.
VectorWires normalise_vertex(Netlist& netlist, const std::string& name, const VectorWires& v);

/// L/|L| + V/|V| in a vertex program, given both unit vectors: 3 adders. Along the half vector of Blinn 1977, of length at most 2.
VectorWires half_vector(Netlist& netlist, const std::string& name, const VectorWires& unit_light, const VectorWires& unit_view);

}  // namespace bump
