#pragma once
// What can be chosen about the scheme of Kim, Lee and Park 2001, of which only the abstract and what Lee 2007 says of it are at hand: the
// transform that Lee 2007, Table 1, charges it or none, how its tables are counted, and widths, which neither gives. Not hardware itself.

#include "channels/parameters.h"
#include "schemes/common/polar_settings.h"
#include "units/scene.h"

namespace bump::kim2001 {

enum class Transform {
  matrix,  ///< L and H into the space of the map by T, B, N: what Table 1 of Lee 2007 charges
  direct   ///< none: the map holds changes of the object's angles
};
enum class Tables {
  separate,  ///< sine and cosine apart, sines of theta_N' read for each dot product: 12 as Table 1 lists
  dual,      ///< sine and cosine as one table of two columns: 8
  shared     ///< and those of theta_N' read once for both dot products: 7
};
enum class Tangent { phi, theta };

struct KimParameters : PolarSettings {
  Transform transform = Transform::matrix;
  Tables tables = Tables::separate;
  Tangent tangent = Tangent::phi;  ///< direct: the object's angle that grows along the map's x axis
  int table_bits = 10;             ///< k: address bits of a quarter turn of sine and cosine
  int word_bits = 12;              ///< w: bits of a table word and of a component of T, B, N
  int light_table_bits = 10;       ///< address bits of the light tables
  int light_word_bits = 16;        ///< bits of an intensity

  /// Angles inside the datapath: a table word resolves a quarter turn.
  Format inner_angle() const { return turns(word_bits + 2); }
  /// Changes of angles in the map, direct: a quarter turn either way.
  Format change_of_phi() const { return angle(texel_phi_bits, texel_phi_bits + 1); }
  Format change_of_theta() const { return angle(texel_theta_bits, texel_theta_bits + 1); }
};

void declare_parameters(Parameters& parameters);
/// Throws Error(input) for transform = direct with map_filter = vector.
KimParameters read_parameters(const Configuration& configuration);

}  // namespace bump::kim2001
