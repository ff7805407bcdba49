#pragma once
// Where the polar angles of N, L and H come from, which Lee 2007 does not say: formed at the vertices and interpolated (angles = vertex),
// or formed per pixel from interpolated vectors by a conversion unit with its own dividers, roots and tables (angles = pixel), reported
// apart. Both also form the in-plane angle alpha from e_theta to the tangent, without which a map made in (T, B, N) does not fit: see
// README.md, "The frame". Timing: vertex work in ALU operations, the conversion unit from its schedule.

#include <vector>

#include "schemes/lee2007/lee_parameters.h"
#include "schemes/scheme.h"

namespace bump::lee2007 {

/// Fills design.vertex, design.interpolants and, for angles = pixel, design.conversion.
void record_polar_vectors(const LeeParameters& p, Design& design);

}  // namespace bump::lee2007
