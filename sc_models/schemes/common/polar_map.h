#pragma once
// Bump maps for schemes on polar angles, and what stands between the texel and the illumination unit: N' as (phi, theta) in the frame
// (T, B, N), or as a vector that is filtered and converted per pixel (polar_vectors.h). Source: Lee 2007, section 3 (map of polar normals);
// texel widths are a reconstruction. The in-plane angle is an addition. Timing: that of the operators recorded.

#include "schemes/common/polar_settings.h"
#include "schemes/scheme.h"

namespace bump {

/// Channels "phi" and "theta", or "x", "y", "z" for map_filter = vector.
BumpEncoding polar_map(const PolarSettings& settings);

struct MapAngles {
  Wire phi, theta;
};
/// Angles of N' in map_phi() and map_theta(): the texel itself; for map_filter = vector the angles of the filtered vector, recorded as an
/// addition: 2 multipliers, 8 adders, 2 dividers, 1 square root, 2 tables.
MapAngles map_angles(Netlist& netlist, const PolarSettings& settings);
/// In an environment unit: gives the illumination unit "map.phi" and "map.theta" where the texel does not hold them.
void output_map_angles(Netlist& environment, const PolarSettings& settings);

/// phi of the map in the frame (e_theta, e_phi, N): negated on mirrored charts, plus alpha, which is one adder. Reads "mirror" and "alpha"
/// where the settings ask for them; recorded as additions.
Wire turned_azimuth(Netlist& netlist, Wire map_phi, const PolarSettings& settings);

}  // namespace bump
