#include "schemes/common/slope_map.h"

#include <algorithm>
#include <cmath>

namespace bump {

void declare_slopes(Parameters& p, const std::string& id) {
  p.integer(id + ".slope_bits", 12, 3, 16, "bits", "bits of a slope of the map, sign included");
  p.integer(id + ".slope_integer_bits", 3, 0, 4, "bits",
            "integer bits of a slope: steeper texels are stored at 2^this, in their direction");
}

SlopeWidths read_slopes(const Configuration& c, const std::string& id) {
  return {static_cast<int>(c.integer(id + ".slope_bits")), static_cast<int>(c.integer(id + ".slope_integer_bits"))};
}

glm::dvec2 slopes_of(const glm::dvec3& normal, double limit) {
  const double steepest = std::max(std::abs(normal.x), std::abs(normal.y));
  if (steepest == 0) return {0, 0};
  const double scale = normal.z * limit >= steepest ? 1 / normal.z : limit / steepest;
  return {normal.x * scale, normal.y * scale};
}

BumpEncoding slope_map(const SlopeWidths& widths, const std::string& u_channel, const std::string& v_channel, double sign) {
  BumpEncoding map;
  map.channels = {{u_channel, widths.texel(), ChannelKind::linear}, {v_channel, widths.texel(), ChannelKind::linear}};
  map.encode = [sign, limit = widths.texel().highest()](const glm::dvec3& normal, double* channels) {
    const glm::dvec2 slopes = slopes_of(normal, limit);
    channels[0] = sign * slopes.x;
    channels[1] = sign * slopes.y;
  };
  map.filterable = true;
  map.note = "two slopes, filtered as any texture";
  return map;
}

}  // namespace bump
