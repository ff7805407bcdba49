#pragma once
// The environment unit of NC2: a = cos b sin Psi, s = sin b, c = cos b cos Psi as in N3 (sums of angles), then two vectoring CORDICs
// (cordic_rotation.h): (a, s) turned onto the x axis gives phi* = atan2(s, a) + phi_N, which the stages add to phi_N as they go, and the
// length r = sin theta*; (c, r) gives theta*. The words of the sine tables lack the gain of the first CORDIC, so that r has the scale of c.
// 6 n adders for n stages, 5 columns read, no multiplier. This project's; in no paper. Timing: that of the operators recorded.

#include "schemes/common/cordic_rotation.h"
#include "schemes/common/object_angles_unit.h"

namespace bump::nc2 {

struct Nc2Parameters : ObjectAnglesParameters {
  int stages = 12;  ///< n, of each CORDIC

  CordicWidths cordic() const;
};

/// Inputs "N.phi", "N.theta" and the map's in input_angle(); outputs "N_object.phi", "N_object.theta" in inner_angle().
Netlist environment_unit(const Nc2Parameters& p);

}  // namespace bump::nc2
