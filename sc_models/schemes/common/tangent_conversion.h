#pragma once
// Longitude and latitude of interpolated vectors by logarithms: for (x, y, z) of any length up to 1, with lx = -log2 |x| and so on and
// s = |lx - lz|,
//   psi = atan2(x, z) from atan 2^-s,   -log2 sqrt(x^2 + z^2) = min(lx, lz) - log2(1 + 2^-2s)/2,   b = atan2(y, sqrt(x^2 + z^2)) likewise.
// Subtractions stand for divisions and the addition of the logarithmic number system for squares, sum and root: no multiplier, divider or
// root. Quadrants follow from signs. Number system: Kingsbury and Rayner 1971; this project's use of it. Timing: that of the operators
// recorded.

#include "datapath/netlist.h"

namespace bump {

struct TangentConversion {
  int component_bits = 12;      ///< c: vectors in sfixed(c, c - 1)
  int inverse_table_bits = 10;  ///< address bits of the arc tangents, 3 of them (4 from 8 on) the binade of a quotient's logarithm
  Format angle{};               ///< of the results, full-turn words
};

/// Netlist "conversion": inputs "L.x" ... "H.z", outputs "L.psi", "L.b", "H.psi", "H.b". For each vector 3 tables of logarithms, 2 of arc
/// tangents, 5 adders.
Netlist tangent_conversion_unit(const TangentConversion& widths);

}  // namespace bump
