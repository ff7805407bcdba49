#pragma once
// What can be chosen about the bump mapping of Ernst et al. 1998: the engine variant, and the widths, of which no source gives any. Not
// hardware itself.

#include "schemes/common/cartesian_widths.h"
#include "schemes/common/slope_map.h"

namespace bump::ernst1998 {

struct ErnstParameters {
  bool high_end = true;  ///< per-pixel lighting as Lee 2007 counts it; otherwise a bump term blended onto Gouraud shading
  CartesianWidths widths;
  SlopeWidths slopes;  ///< high_end: texels (fu, fv)
  int texel_bits = 8;  ///< gouraud: bits of a component of a normalised texel

  Format texel() const { return sfixed(texel_bits, texel_bits - 1); }
};

void declare_parameters(Parameters& parameters);
ErnstParameters read_parameters(const Configuration& configuration);

}  // namespace bump::ernst1998
