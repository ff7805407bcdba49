#pragma once
// A bump map with its pole on the y axis: N' = (cos b sin psi, sin b, cos b cos psi), psi the longitude in the xz plane from +z, b the
// latitude above it. A rotation about y is then one addition, psi + theta_N, and a flat texel is (0, 0), far from the poles, so that the
// map filters like vectors. N' must lie along (e_theta, e_phi, N), the frame that Ry(-theta_N) Rz(-phi_N) delivers. On a surface whose
// tangents run along parallels or meridians of the shading axes the host turns the map once by a constant; on any other a texel is turned
// by alpha per pixel, which is counted as an addition. This project's; in no paper. Timing: that of the operators recorded.

#include <string>

#include "channels/parameters.h"
#include "schemes/common/polar_settings.h"
#include "schemes/scheme.h"

namespace bump {

/// Where the tangent T points, seen from (e_theta, e_phi, N).
enum class Chart {
  parallel,  ///< T = e_phi, as on a globe whose map runs round the z axis
  meridian,  ///< T = e_theta
  any        ///< T = e_theta turned by alpha about N, an interpolated angle
};

/// What a texel holds.
enum class TexelAs {
  angles,         ///< psi and b
  vector,         ///< along (e_theta, e_phi, N)
  tangent_vector  ///< along (T, B, N), as the scene's own
};

struct YPoleSettings {
  TexelAs texel = TexelAs::angles;
  int angle_bits = 12;                              ///< a: bits of a turn in the angles that arrive, psi and b of a filtered texel included
  int inverse_table_bits = 10;                      ///< ki: address bits of arc tangents, arc sines, reciprocals
  int texel_psi_bits = 8, texel_latitude_bits = 8;  ///< of half a turn
  int texel_bits = 8;                               ///< of a component, for vectors
  bool filtered = true;                             ///< false: nearest texel
  Angles angles = Angles::vertex;
  Chart chart = Chart::parallel;
  bool mirror = false;  ///< one flag a triangle for mirrored texture charts

  /// Of a filtered component: four bits more than a texel's.
  Format component() const { return sfixed(texel_bits + 4, texel_bits + 3); }
  Format input_angle() const { return turns(angle_bits); }
  /// What polar_vectors.h and other users of polar settings read.
  PolarSettings polar() const;
};

/// Declares "<id>.angle_bits", ".inverse_table_bits", ".texel_psi_bits", ".texel_latitude_bits", ".map_filter", ".angles", ".frame",
/// ".mirror"; for vectors ".texel_bits" in place of the two of angles.
void declare_y_pole_settings(Parameters& parameters, const std::string& id, TexelAs texel = TexelAs::angles);
YPoleSettings read_y_pole_settings(const Configuration& configuration, const std::string& id, TexelAs texel = TexelAs::angles);

/// Channels "psi" and "latitude", each over half a turn; or "x", "y", "minus_z".
BumpEncoding y_pole_map(const YPoleSettings& settings);

struct YPoleWires {
  Wire psi, latitude;
};

/// What turns a texel by alpha: widths of its tables and words.
struct TurnWidths {
  int table_bits = 10;  ///< address bits of a quarter turn
  int word_bits = 12;   ///< of a table word
};

/// N' along (e_theta, e_phi, N) in input_angle(). Reads "map.psi", "map.latitude"; "mirror" where the settings ask for it (sign logic, an
/// addition); for Chart::any "alpha", and then records as an addition the way to a vector (4 adders, 3 tables), the turn (4 multipliers, 2
/// adders, 1 table) and the way back (1 multiplier, 3 tables).
YPoleWires y_pole_texel(Netlist& netlist, const YPoleSettings& settings, const TurnWidths& widths);

struct VectorTexelWires {
  Wire x, y, minus_z;
};

/// N' as a vector in component(), along the axes that it is stored in; for Chart::any along (e_theta, e_phi, N), its x and y as products of
/// `widths.word_bits` + 2 fraction bits: an addition of 4 multipliers, 2 adders, 1 table. Reads "map.x", "map.y", "map.minus_z"; "mirror",
/// "alpha" as above.
VectorTexelWires vector_texel(Netlist& netlist, const YPoleSettings& settings, const TurnWidths& widths);

}  // namespace bump
