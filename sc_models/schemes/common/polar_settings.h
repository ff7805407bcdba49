#pragma once
// What every scheme on polar angles leaves to choose: widths of the angles that arrive, the bump texel, where the angles come from and how
// a map made in (T, B, N) is brought into the frame (e_theta, e_phi, N). Conventions of Lee 2007, Eqs 19-21: phi from +x, theta from +z.
// Not hardware itself; polar_vectors.h and polar_map.h record what these choices cost.

#include <string>

#include "channels/parameters.h"
#include "datapath/format.h"

namespace bump {

enum class Angles { vertex, pixel };
/// What is done about the angle from e_theta to the tangent: nothing, one angle a face, one a pixel; or phi and the sign of theta of N are
/// chosen so that the tangent points along e_phi (parallel) or e_theta (meridian), for surfaces where it does (y_pole_map.h).
enum class InPlane { none, face, pixel, parallel, meridian };
enum class MapFilter { nearest, linear, vector };

struct PolarSettings {
  int angle_bits = 10;                           ///< a: bits of a turn in the angles that arrive
  int inverse_table_bits = 8;                    ///< ki: address bits of arc tangents (and of the scheme's other inverse functions)
  int texel_phi_bits = 8, texel_theta_bits = 8;  ///< of a turn, of a quarter turn
  int texel_vector_bits = 8;                     ///< of a component, map_filter = vector
  MapFilter map_filter = MapFilter::nearest;     ///< vector: texels are vectors, filtered as such and converted per pixel
  Angles angles = Angles::vertex;
  InPlane frame = InPlane::pixel;
  bool mirror = false;  ///< one flag a triangle for mirrored texture charts

  Format input_angle() const { return turns(angle_bits); }
  /// Angles of N' as the illumination unit takes them.
  Format map_phi() const { return turns(map_filter == MapFilter::vector ? angle_bits : texel_phi_bits); }
  Format map_theta() const { return map_filter == MapFilter::vector ? turns(angle_bits) : uangle(texel_theta_bits, texel_theta_bits + 2); }
};

/// Declares "<id>.angle_bits", ".texel_phi_bits", ".texel_theta_bits", ".texel_vector_bits", ".map_filter" and ".angles".
void declare_polar_settings(Parameters& parameters, const std::string& id, const PolarSettings& defaults);
/// Declares "<id>.frame" and ".mirror".
void declare_in_plane_settings(Parameters& parameters, const std::string& id);

/// Read what the two functions above declare; other members stay as they are.
void read_polar_settings(const Configuration& configuration, const std::string& id, PolarSettings& settings);
void read_in_plane_settings(const Configuration& configuration, const std::string& id, PolarSettings& settings);

}  // namespace bump
