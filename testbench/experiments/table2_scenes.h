#pragma once
// The pictures of Lee 2007's Table 2, as far as they can be known. The paper names three: a wooden wall on a plane, a brick wall on a cube,
// a map of the world (512 x 256) on a sphere; it gives neither camera, light, material nor the height of the relief. What stands in for
// them is here and nowhere else, all of it this project's assumption:
//   * geometry, textures, relief and camera are those of the shipped scene files;
//   * one point light of intensity 1, as far from the object's centre as the eye, at a stated angle from the eye as seen from there, to the
//     viewer's right. The side is a convention, and much hangs on it: table2 --angles turns the light around the line of sight;
//   * the angles 65, 11 and 27 degrees: a light far from the viewer, near it, and between the two; table2 --angles shows what others give;
//   * an ordinary material, neither dull nor shiny.

#include <array>
#include <string_view>

#include "units/scene.h"

namespace bump {

struct Table2Scene {
  std::string_view name;         ///< as Table 2 calls it
  std::string_view shipped;      ///< scene file
  double light_degrees;          ///< between light and eye, seen from the object's centre
  std::string_view description;  ///< what the paper says
};

inline constexpr std::array<Table2Scene, 3> table2_scenes{{{"plane", "wood_plane", 65, "wooden wall on a plane"},
                                                           {"cube", "brick_cube", 11, "brick wall on a cube"},
                                                           {"sphere", "world_sphere", 27, "map of the world, 512 x 256, on a sphere"}}};

inline constexpr Material table2_material{0.12, 0.75, 0.30, 20};

/// Where the light stands: degrees from the eye, and from the viewer's right (counter-clockwise, 90 is above).
struct Table2Light {
  double degrees = 0, azimuth = 0;
};

/// For the dependence on the light: angles at azimuth 0, azimuths at the scene's own angle.
inline constexpr std::array<double, 6> table2_angles{0, 15, 30, 45, 60, 75};
inline constexpr std::array<double, 8> table2_azimuths{0, 45, 90, 135, 180, 225, 270, 315};

/// The shipped scene with the light and the material above. Throws Error(input) if the eye stands in the centre of the first object.
Scene arrange_table2_scene(const Scene& shipped, const Table2Light& light);

}  // namespace bump
