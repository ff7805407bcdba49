#pragma once
// What can be chosen about the scheme of Peercy, Airey and Cabral 1997: where the transform into tangent space happens, how vectors are
// normalised, and the widths, of which the paper gives none. Not hardware itself.

#include "channels/parameters.h"
#include "datapath/format.h"
#include "units/scene.h"

namespace bump::peercy1997 {

struct PeercyParameters {
  bool transform_per_pixel = true;  ///< Lee 2007, Table 1, charges the transform to the pixel; the paper does it at the vertices
  bool divider = true;              ///< square root and dividers, or a table of reciprocal roots
  int word_bits = 12;               ///< bits of a vector component, sign included
  int texel_bits = 8;               ///< bits of a component in the map
  int light_table_bits = 10;        ///< address bits of the power table
  int root_table_bits = 10;         ///< address bits of the reciprocal root table

  /// A component in [-1, 1).
  Format component() const { return sfixed(word_bits, word_bits - 1); }
  Format texel() const { return sfixed(texel_bits, texel_bits - 1); }
};

void declare_parameters(Parameters& parameters);
PeercyParameters read_parameters(const Configuration& configuration);

/// PSNR in dB below which the fixed-point image must not fall against the same scheme in double precision, for a material. See README.md,
/// "Fixed point".
double quantisation_floor_db(const PeercyParameters& p, const Material& material);

}  // namespace bump::peercy1997
