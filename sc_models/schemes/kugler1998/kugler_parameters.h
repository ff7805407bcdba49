#pragma once
// Widths and choices of the scheme of Kugler 1998. Lee et al. 2007 gives the sizes of its maps (32 Kbytes, and 1 Mbyte for each light map);
// all other widths are reconstructions, see README.md.

#include "channels/parameters.h"
#include "datapath/format.h"

namespace bump::kugler1998 {

enum class Frame { none, face, vertex, pixel };
enum class MapHolds { angle, change };

struct KuglerParameters {
  Frame frame = Frame::vertex;           ///< where psi comes from
  MapHolds map_holds = MapHolds::angle;  ///< theta', or theta' less theta_N
  double strength = 1;                   ///< of the bumps
  double max_tilt = 60;                  ///< degrees: theta_b of the last code
  int angle_bits = 12;                   ///< a: bits of a turn in phi_N, psi, phi_1, phi'
  int table_bits = 10;                   ///< k: address bits of tables of one index
  int word_bits = 12;                    ///< w: fraction bits of sines, cosines and their products
  int texel_phi_bits = 8;                ///< of a turn
  int map_phi_bits = 5;                  ///< address bits of phi_1, for half a turn
  int map_theta_bits = 5;                ///< address bits of theta_N, for a quarter turn
  int map_tilt_bits = 4;                 ///< address bits of theta_b, and its bits in a bump texel
  int map_word_bits = 8;                 ///< bits of theta' and of the size of delta
  int light_map_bits = 20;               ///< address bits of a light map
  int light_word_bits = 8;               ///< bits of its words
  int light_integer_bits = 1;            ///< of those, in front of the point

  Format component() const { return sfixed(component_bits, component_bits - 1); }  ///< of N
  Format turn() const { return turns(angle_bits); }
  Format map_phi() const { return turns(texel_phi_bits); }
  /// theta_b and theta_N as fields of the map's address: the last code stands for the largest angle.
  Format tilt_code() const { return ufixed(map_tilt_bits, map_tilt_bits); }
  Format theta_code() const { return ufixed(map_theta_bits, map_theta_bits); }
  Format light_word() const { return ufixed(light_word_bits, light_word_bits - light_integer_bits); }
  /// Fields of a light map's address: the hemisphere is one bit.
  int row_bits() const { return (light_map_bits - 1) / 2; }
  int column_bits() const { return light_map_bits - 1 - row_bits(); }

  static constexpr int component_bits = 16;
  /// |N.x| and |N.y| up to this are on the axis: phi_N is 0 there.
  static constexpr double axis = 1.0 / 1024;
};

/// The highest value of a code of `bits` fraction bits.
inline double last_code(int bits) {
  return 1 - ufixed(bits, bits).step();
}

void declare_parameters(Parameters& parameters);
KuglerParameters read_parameters(const Configuration& configuration);

}  // namespace bump::kugler1998
