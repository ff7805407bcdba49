#pragma once
// What can be chosen about the scheme of Lee et al. 2007: which reading of the paper, and the widths that the paper leaves open. Every
// default is the reading under which Table 1 closes, with the sign corrections without which the image is wrong. Not hardware itself.

#include "channels/parameters.h"
#include "datapath/format.h"
#include "schemes/common/polar_settings.h"
#include "units/scene.h"

namespace bump::lee2007 {

struct LeeParameters : PolarSettings {
  int form = 11;               ///< adders of the illumination unit: 11 (Table 1) or 13 (section 5.2)
  bool half_xy = false;        ///< X, Y halved as Eqs 5-6 print them
  bool exact_eq16 = false;     ///< theta' on the sphere instead of the linear Eq 16
  bool exact_x_prime = false;  ///< x' from cos theta_A instead of cos theta_x
  bool abs_fix = true;         ///< |y| and |Z| in Eq 16
  bool quadrant_fix = true;    ///< arc tangent over the full turn
  bool hemisphere_bit = true;  ///< theta_x unfolded by the sign of cos theta_A
  int table_bits = 8;          ///< k: address bits of a quarter turn of sine, cosine and reciprocal
  int word_bits = 16;          ///< w: bits of a table word
  int light_table_bits = 10;   ///< address bits of the light tables
  int light_word_bits = 16;    ///< bits of an intensity

  /// Angles inside the datapath: a table word resolves a quarter turn.
  Format inner_angle() const { return turns(word_bits + 2); }
};

void declare_parameters(Parameters& parameters);
LeeParameters read_parameters(const Configuration& configuration);

/// PSNR in dB below which the fixed-point image must not fall against the same scheme in double precision, for a material. See README.md,
/// "How near the hardware is to its own formula".
double quantisation_floor_db(const LeeParameters& p, const Material& material);

}  // namespace bump::lee2007
