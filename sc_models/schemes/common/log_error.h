#pragma once
// What logarithms add to the bound of polar_error.h on how far a scheme in fixed point can be from itself in double precision. A measuring
// instrument, not hardware.

#include "schemes/common/log_reads.h"
#include "units/scene.h"

namespace bump {

/// A floor in dB lowered by sums of `terms` products of `factors` factors each; at least 3.
double logarithmic_floor_db(double floor_db, const LogWidths& widths, int factors, int terms, const Material& material);

}  // namespace bump
