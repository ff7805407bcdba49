#include "schemes/peercy1997/peercy_parameters.h"

namespace bump::peercy1997 {

void declare_parameters(Parameters& p) {
  p.choice("peercy1997.transform", "pixel", {"pixel", "vertex"},
           "transform of L and H into tangent space: per pixel as Lee 2007, Table 1, charges it, or at the vertices as published");
  p.choice("peercy1997.normaliser", "divider", {"divider", "table"},
           "normalisers: square root and three dividers, or a table of reciprocal roots and three multipliers");
  declare_widths(p, "peercy1997");
  p.integer("peercy1997.texel_bits", 8, 4, 16, "bits", "bits of a component of the map");
  p.integer("peercy1997.root_table_bits", 10, 6, 14, "bits", "address bits of the reciprocal root table (normaliser = table)");
}

PeercyParameters read_parameters(const Configuration& c) {
  PeercyParameters p;
  p.transform_per_pixel = c.choice("peercy1997.transform") == "pixel";
  p.widths = read_widths(c, "peercy1997");
  p.widths.divider = c.choice("peercy1997.normaliser") == "divider";
  p.texel_bits = static_cast<int>(c.integer("peercy1997.texel_bits"));
  p.widths.root_table_bits = static_cast<int>(c.integer("peercy1997.root_table_bits"));
  return p;
}

}  // namespace bump::peercy1997
