#pragma once
// The environment unit of Kugler 1998 as Lee et al. 2007 counts it (Table 1: 5 multipliers, 2 adders, 3 tables, 1 map of 32 Kbytes): the
// interpolated normal becomes polar angles, the bump is added to them by two adders and one map, which are three rotations. What the five
// multipliers and three tables do is a reconstruction, see README.md. N need not have unit length. Timing: that of the operators recorded.

#include "datapath/netlist.h"
#include "schemes/kugler1998/kugler_parameters.h"

namespace bump::kugler1998 {

/// Inputs N.x N.y N.z, psi (unless frame = none), map.phi, map.theta; outputs bumped.phi, bumped.theta: N' in polar angles, object space.
Netlist environment_unit(const KuglerParameters& p);

}  // namespace bump::kugler1998
