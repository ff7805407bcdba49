#pragma once
// Look-up tables of the scheme of Kugler 1998 as README.md reconstructs it, and its map of bumps: the spherical triangle of the pole, N and
// N', solved in advance. Contents from the formulas only. Timing: one access each; RECIP and ATAN have two read ports.

#include "datapath/table.h"
#include "schemes/kugler1998/kugler_parameters.h"

namespace bump::kugler1998 {

/// Fraction bits of tangents, up to 2^17.
constexpr int tangent_fraction = 14;
Format tangent_format();

/// "RECIP": 1 / x, 0 <= x < 1, over the 16 binades that a component of N has.
TablePtr reciprocal_table(const KuglerParameters& p);
/// "ATAN", of a tangent: "angle" in turns; "code", the same as an address field of the map, whose last code is a quarter turn.
TablePtr arc_tangent_table(const KuglerParameters& p);
/// "SEC", of 2 phi: 1 / cos phi up to an eighth of a turn, 1 / sin phi beyond.
TablePtr secant_table(const KuglerParameters& p);
/// "BUMP", of phi_1, theta_N, theta_b: "theta" of N' (map_holds = change: less theta_N), and "delta", its azimuth from that of N.
TablePtr bump_table(const KuglerParameters& p);
/// "RECIP_1": 1 / x, 1 <= x < 2.
TablePtr paraboloid_table(const KuglerParameters& p);

}  // namespace bump::kugler1998
