#pragma once
// The high-end engine of Ernst et al. 1998 as Lee 2007 counts it: the datapath of Peercy, Airey and Cabral 1997 with a map of k = -1, whose
// texel is (fu, fv, 1). Transform of L and H per pixel 18 multipliers, 12 adders; three normalisers 9, 6, 9 dividers, 3 square roots;
// illumination 7, 5, 1 table. Leaves out anything of the original that Lee 2007 does not mention. Timing: that of the operators recorded.

#include "schemes/ernst1998/ernst_parameters.h"
#include "schemes/scheme.h"

namespace bump::ernst1998 {

/// The whole design.
Design high_end_design(const ErnstParameters& p, const Material& material);

}  // namespace bump::ernst1998
