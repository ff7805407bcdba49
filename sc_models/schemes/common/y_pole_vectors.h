#pragma once
// Polar angles of N for a bump map whose frame is that of the angles themselves: (phi_N, theta_N) and (phi_N + 180 degrees, -theta_N) are
// one direction but turn (e_theta, e_phi) by half a turn, and on the z axis phi_N is free. Here both are used: of the two pairs the one is
// taken whose e_phi (or e_theta) points along T, and on the axis phi_N comes from T. So a torus about z has a frame without a jump, and a
// plane z = 0 or the cap of a cube needs no in-plane angle. This project's; in no paper. At the vertices (`real`) or per pixel (fixed
// point). Timing: that of the operators recorded.

#include <string>

#include "schemes/common/polar_conversion.h"
#include "schemes/common/polar_settings.h"

namespace bump {

/// Angles of `normal`, theta signed, such that `tangent` has no negative component along e_phi (InPlane::parallel) or e_theta
/// (InPlane::meridian). As polar_angles(), and 2 multipliers, 1 adder more along parallels, 4 and 2 along meridians; `product` is the
/// signed format of their products.
PolarWires chart_angles(Netlist& netlist, const std::string& name, const VectorWires& normal, const VectorWires& tangent, InPlane frame,
                        const PolarFormats& formats, const Format& product, double axis_limit);

}  // namespace bump
