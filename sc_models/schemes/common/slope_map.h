#pragma once
// A bump map of two slopes a texel, as Blinn's perturbation and Ernst's k = -1 map need it: the scene's unit normal (x, y, z) is the
// normalised (x/z, y/z, 1). Slopes are unbounded, so a steep texel keeps its direction and is stored at the limit of the format; an
// overhang is stored at the limit too. Preprocessing by the host: no hardware, no time. Source: Peercy, Airey and Cabral 1997, Eqs 8-11
// with k = 1 (square patch).

#include <glm/glm.hpp>
#include <string>

#include "channels/parameters.h"
#include "schemes/scheme.h"

namespace bump {

/// Widths of a slope.
struct SlopeWidths {
  int bits = 12;         ///< sign included
  int integer_bits = 3;  ///< slopes lie in [-2^integer_bits, 2^integer_bits)

  Format texel() const { return sfixed(bits, bits - 1 - integer_bits); }
};

/// Keys "id.slope_bits" and "id.slope_integer_bits".
void declare_slopes(Parameters& parameters, const std::string& id);
SlopeWidths read_slopes(const Configuration& configuration, const std::string& id);

/// (x/z, y/z) of a unit normal, scaled down together until neither is beyond +-limit. (0, 0) for x = y = 0, whatever z.
glm::dvec2 slopes_of(const glm::dvec3& normal, double limit);

/// Two channels of those slopes times `sign`, filtered as any texture.
BumpEncoding slope_map(const SlopeWidths& widths, const std::string& u_channel, const std::string& v_channel, double sign);

}  // namespace bump
