#pragma once
// What can be chosen about the scheme of Peercy, Airey and Cabral 1997: where the transform into tangent space happens, what the map holds,
// how vectors are normalised, and the widths, of which the paper gives none. Not hardware itself.

#include "channels/parameters.h"
#include "datapath/format.h"
#include "schemes/common/cartesian_widths.h"
#include "schemes/peercy1997/surface_maps.h"

namespace bump::peercy1997 {

struct PeercyParameters {
  bool transform_per_pixel = true;  ///< Lee 2007, Table 1, charges the transform to the pixel, the paper to the vertices. Tangent maps only
  MapSpace map = MapSpace::tangent;
  Perturbation perturbation = Perturbation::square_patch;
  CartesianWidths widths;
  int texel_bits = 8;  ///< bits of a component in the map

  Format texel() const { return sfixed(texel_bits, texel_bits - 1); }
};

void declare_parameters(Parameters& parameters);
PeercyParameters read_parameters(const Configuration& configuration);

}  // namespace bump::peercy1997
