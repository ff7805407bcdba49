#pragma once
// The illumination unit of Kugler 1998 as Lee et al. 2007 counts it (Table 1: 8 multipliers, 4 adders, 5 tables, 2 maps of 1 Mbyte, colour
// blending included): the direction of N' becomes an address, where a diffuse and a specular light map hold what all lights give. No dot
// product per pixel. The address by a paraboloid is a reconstruction, see README.md. Timing: that of the operators recorded; the fetch
// between both netlists is the light-map fetch unit's.

#include "schemes/kugler1998/kugler_parameters.h"
#include "schemes/scheme.h"

namespace bump::kugler1998 {

/// "diffuse" holds kd max(0, N.L), "specular" max(0, N.H)^n, summed over the lights. Address: 4 multipliers, 2 adders, 5 tables.
LightMaps light_maps(const KuglerParameters& p, const Material& material);

/// intensity = light.diffuse + ks light.specular: 1 multiplier, 1 adder.
Netlist illumination_unit(const KuglerParameters& p, const Material& material);

}  // namespace bump::kugler1998
