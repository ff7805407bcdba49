#pragma once
// What the scheme of Kugler 1998 interpolates: N as a vector, and psi, the angle from e_theta to the tangent about N, by which a bump map
// made in (T, B, N) turns into the frame of N's meridian. No light, no viewer: these are in the light maps. psi is a reconstruction, see
// README.md. Timing: vertex work in ALU operations; frame = pixel has a conversion unit with its own schedule.

#include "schemes/kugler1998/kugler_parameters.h"
#include "schemes/scheme.h"

namespace bump::kugler1998 {

/// Fills design.vertex, design.interpolants and, for frame = pixel, design.conversion.
void record_vertex_program(const KuglerParameters& p, Design& design);

}  // namespace bump::kugler1998
