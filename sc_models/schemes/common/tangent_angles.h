#pragma once
// L and H as longitude and latitude in tangent space: psi = atan2(x, z), b = atan2(y, sqrt(x^2 + z^2)) of (x, y, z) along (T, B, N), with
// the pole on y as the bump map (y_pole_map.h). Light and half vector are turned into the frame at the vertices, as Peercy, Airey and
// Cabral 1997 do with vectors, and interpolated as two angles each: no rotation is left for a pixel, and no chart is singular where N
// points. The angles mean nothing only where a vector lies along +-y, on the horizon. With angles = pixel the turned vectors are
// interpolated, and a conversion unit in front makes the angles. This project's; in no paper. Timing: that of the operators recorded; the
// vertex program runs on the vertex processor.

#include <string>

#include "schemes/common/y_pole_design.h"

namespace bump {

struct TangentAngleParameters : YPoleParameters {
  int component_bits = 12;        ///< of an interpolated vector, angles = pixel
  int half_turn_table_bits = 10;  ///< address bits of tables of the difference of longitudes, for half a turn

  TangentAngleParameters() { chart = Chart::meridian; }  // the map as it is: along (T, B, N)
};

/// Declares "<id>.angle_bits", ".texel_psi_bits", ".texel_latitude_bits", ".map_filter", ".angles", ".component_bits",
/// ".inverse_table_bits", ".half_turn_table_bits" and what declare_sum_widths() declares.
void declare_tangent_angle_parameters(Parameters& parameters, const std::string& id);
TangentAngleParameters read_tangent_angle_parameters(const Configuration& configuration, const std::string& id);

struct LongitudeLatitude {
  Wire psi, b;
};

/// Inputs "<name>.psi", "<name>.b" in p.input_angle().
LongitudeLatitude input_tangent_angles(Netlist& netlist, const std::string& name, const TangentAngleParameters& p);

/// Vertex program, interpolants "L.psi", "L.b", "H.psi", "H.b" (angles = pixel: "L.x" ... "H.z" and the conversion unit), map and the
/// bound of the self-check, around two units.
Design tangent_angle_design(const TangentAngleParameters& p, Netlist environment, Netlist illumination, const Material& material);

}  // namespace bump
