#pragma once
// The two units of CD0: for a vector A in {L, H}, d = phi_A - phi_N, G = sin theta_A cos d, K = sin theta_A sin d, z = cos theta_A, N' =
// (psi, b) about the y axis, Psi = psi + theta_N,
//   w = z cos Psi + G sin Psi      a rotation of (z, G) by -Psi, of which one component is needed
//   N'.A' = w cos b + K sin b      a rotation of (w, K) by -b, of which one component is needed                        (CD0)
// both by unrolled CORDIC (cordic_rotation.h), whose directions follow from Psi and b and turn L and H alike. The gains of both rotations
// are in the words of the sine tables. 10 n + 5 adders for n stages, 10 columns read, no multiplier. This project's; in no paper. Timing:
// that of the operators recorded.

#include "schemes/common/cordic_rotation.h"
#include "schemes/common/y_pole_design.h"

namespace bump::cd0 {

struct Cd0Parameters : YPoleParameters {
  int stages = 12;  ///< n, of each rotation

  CordicWidths cordic() const;
};

/// Inputs "N.phi", "N.theta", "L.phi" ... in input_angle(), the map's; outputs "L.w", "L.K", those of H, in the component format, and
/// "bump.latitude" in input_angle().
Netlist environment_unit(const Cd0Parameters& p);
/// Nodes "N_L.dot", "N_H.dot"; output "intensity".
Netlist illumination_unit(const Cd0Parameters& p, const Material& material);

}  // namespace bump::cd0
