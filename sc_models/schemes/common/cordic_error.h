#pragma once
// What CORDIC adds to the bound of polar_error.h on how far a scheme in fixed point can be from itself in double precision: both take the
// same number of stages, but where the angle left is near 0 a rounding decides a stage differently. A measuring instrument, not hardware.

#include "units/scene.h"

namespace bump {

/// A floor in dB lowered by `rotations` CORDICs of `stages` stages one after another; at least 3.
double cordic_floor_db(double floor_db, int stages, int rotations, const Material& material);

}  // namespace bump
