#pragma once
// The low-end engine of Ernst et al. 1998, of which only the abstract is known: triangles stay Gouraud-shaded, and a bump term is blended
// onto the fragment. Here I = I_Gouraud + kd (max(0, N'.L') - max(0, L'z)): what the bump adds to the diffuse intensity of the flat
// surface. Environment 3 multipliers, 3 adders; illumination 1 and 1; no divider, root or table. Leaves out bumps in highlights. Timing:
// that of the operators recorded. Source: a reconstruction; the original blend is unknown.

#include "schemes/ernst1998/ernst_parameters.h"
#include "schemes/scheme.h"

namespace bump::ernst1998 {

/// The whole design.
Design gouraud_design(const ErnstParameters& p, const Material& material);

}  // namespace bump::ernst1998
