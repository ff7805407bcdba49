#pragma once
// The units of EXACT10: L and H rotated by sums of angles as far as those go, and by multipliers for the rest; the bump map holds vectors.
// With G and K of a vector A in {L, H} (sums_projection.h):
//   x' = G cos theta_N - (sin(theta_A + theta_N) - sin(theta_A - theta_N))/2        along e_theta
//   y' = K                                                                          along e_phi
//   z' = G sin theta_N + (cos(theta_A + theta_N) + cos(theta_A - theta_N))/2        along N
// On a chart of parallels T = e_phi and B = -e_theta, so that L' = (y', -x', z') along (T, B, N): the map is the scene's own. 4
// multipliers, 22 adders, 9 tables; the illumination unit adds 6 multipliers, 5 adders, 2 tables. This project's; in no paper. Timing: that
// of the operators recorded.

#include "schemes/common/y_pole_design.h"

namespace bump::exact10 {

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(); outputs "L_ref.x", "L_ref.y", "L_ref.z", the same of H: along (T, B, N), or
/// along (e_theta, e_phi, N) for Chart::any.
Netlist environment_unit(const YPoleParameters& p);

/// N'.L', N'.H' and the light tables: 6 multipliers, 5 adders, 2 tables.
Netlist illumination_unit(const YPoleParameters& p, const Material& material);

}  // namespace bump::exact10
