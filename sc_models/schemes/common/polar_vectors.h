#pragma once
// Where the polar angles of N, L and H come from, which the papers on polar schemes do not say: formed at the vertices and interpolated
// (angles = vertex), or formed per pixel from interpolated vectors by a conversion unit with its own dividers, roots and tables (angles =
// pixel), reported apart. Also formed: the in-plane angle alpha from e_theta to the tangent, without which a map made in (T, B, N) does not
// fit the frame (e_theta, e_phi, N) of a rotation by angles (an addition). Timing: vertex work in ALU operations, the conversion unit from
// its schedule.

#include "schemes/common/polar_settings.h"
#include "schemes/scheme.h"

namespace bump {

/// What the environment unit takes for the frame: angles of N (interpolants "N.phi", "N.theta", and "alpha", "mirror" as the settings ask
/// for them), or the vectors N, T, B as a matrix, which needs neither alpha nor mirror.
enum class NormalAs { angles, matrix };

/// Fills design.vertex, design.interpolants and, for angles = pixel, design.conversion.
void record_polar_vectors(const PolarSettings& settings, NormalAs normal_as, Design& design);

}  // namespace bump
