#include "schemes/common/cordic_error.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump {

double cordic_floor_db(double floor_db, int stages, int rotations, const Material& material) {
  // Either way leaves at most the last stage's angle, so that two ways differ by at most twice that.
  const double angle = rotations * 2 * std::atan(std::ldexp(1.0, 1 - stages));
  return std::max(3.0, -20 * std::log10(std::pow(10.0, -floor_db / 20) + angle * angular_slope(material)));
}

}  // namespace bump
