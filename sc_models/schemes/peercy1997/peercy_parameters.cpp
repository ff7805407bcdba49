#include "schemes/peercy1997/peercy_parameters.h"

namespace bump::peercy1997 {

void declare_parameters(Parameters& p) {
  p.choice(
      "peercy1997.transform", "pixel", {"pixel", "vertex"},
      "transform of L and H into tangent space: per pixel as Lee 2007, Table 1, charges it, or at the vertices as published; not read with "
      "map = object_space");
  p.choice("peercy1997.map", "tangent", {"tangent", "object_space"},
           "space of the normals in the map: tangent space, or the object's own, which needs no transform and a map for each object")
      .decides = "which map there is: one that any surface can wear, or one made for each object";
  p.choice("peercy1997.perturbation", "square_patch", {"square_patch", "surface"},
           "normals in the map: the scene's own, which know no surface (Eqs 8-11), or from heights and the derivatives of each surface "
           "(Eqs 3-6)")
      .decides = "which normals the map holds";
  p.choice("peercy1997.normaliser", "divider", {"divider", "table"},
           "normalisers: square root and three dividers, or a table of reciprocal roots and three multipliers");
  declare_widths(p, "peercy1997");
  p.integer("peercy1997.texel_bits", 8, 3, 16, "bits", "bits of a component of the map");
  p.integer("peercy1997.root_table_bits", 10, 4, 14, "bits", "address bits of the reciprocal root table (normaliser = table)");
}

PeercyParameters read_parameters(const Configuration& c) {
  PeercyParameters p;
  p.transform_per_pixel = c.choice("peercy1997.transform") == "pixel";
  p.map = c.choice("peercy1997.map") == "tangent" ? MapSpace::tangent : MapSpace::object;
  p.perturbation = c.choice("peercy1997.perturbation") == "surface" ? Perturbation::surface : Perturbation::square_patch;
  p.widths = read_widths(c, "peercy1997");
  p.widths.divider = c.choice("peercy1997.normaliser") == "divider";
  p.texel_bits = static_cast<int>(c.integer("peercy1997.texel_bits"));
  p.widths.root_table_bits = static_cast<int>(c.integer("peercy1997.root_table_bits"));
  return p;
}

}  // namespace bump::peercy1997
