#pragma once
// How far the light vector that a design's environment unit delivers is from the true one, for random surface points: what a cheaper
// rotation loses. In double precision, without interpolation or texels, so that only the formula counts. A measurement, not hardware.
// Source of the frames: schemes/scheme.h, DeliveredDirection.

#include <optional>

#include "schemes/scheme.h"

namespace bump {

struct DirectionError {
  double mean_degrees = 0, rms_degrees = 0, max_degrees = 0;
};

/// N uniform over the sphere, L and V uniform over its hemisphere, T at random; 16384 points, always the same. Null if the design delivers
/// no light vector.
std::optional<DirectionError> light_direction_error(const Design& design);

}  // namespace bump
