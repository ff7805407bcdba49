#pragma once
// Word widths of a Cartesian per-pixel datapath: one set for all schemes that compute with vectors, so that they differ by what they
// compute and not by how finely. No paper gives any. Not hardware itself.

#include <string>

#include "channels/parameters.h"
#include "datapath/format.h"
#include "schemes/scheme.h"
#include "units/scene.h"

namespace bump {

struct CartesianWidths {
  int word_bits = 12;         ///< bits of a vector component, sign included
  int light_table_bits = 10;  ///< address bits of the power table
  int light_word_bits = 16;   ///< bits of an intensity
  bool divider = true;        ///< normalisers: square root and dividers, or a table of reciprocal roots
  int root_table_bits = 10;   ///< address bits of the reciprocal root table

  static constexpr int guard_bits = 2;  ///< of products that are summed: the floors of three would bias a component by 1.5 units

  /// Of an interpolated component, in [-1, 1).
  Format component() const { return sfixed(word_bits, word_bits - 1); }
  /// Of a component of a unit vector behind its normaliser: one integer bit, as 1 itself occurs.
  Format unit() const { return sfixed(word_bits + 1, word_bits - 1); }
  /// Of products and their sums, in [-2^integer_bits, 2^integer_bits).
  Format product(int integer_bits = 1) const { return sfixed(integer_bits + 1 + product_fraction(), product_fraction()); }
  int product_fraction() const { return word_bits - 1 + guard_bits; }
};

/// Keys "id.word_bits", "id.light_table_bits" and "id.light_word_bits".
void declare_widths(Parameters& parameters, const std::string& id);
CartesianWidths read_widths(const Configuration& configuration, const std::string& id);

/// The PSNR in dB at peak intensity 1 that a scheme promises to the self-check, fixed point against double precision: -20 log10(e s + t)
/// for e the worst error of a direction by words, map and root table (radians; the floor takes it as if every pixel had it), s the angular
/// slope of the material and t the error of its light table; at least 3. `texel_step` is one unit of the map's last place.
double direction_floor_db(const CartesianWidths& widths, double texel_step, const Material& material);
/// Sets the design's stated bound to it, and leaves out pixels at which a normaliser ("..._unit") gets a vector shorter than 1/4. The environment
/// netlist must be recorded already.
void state_direction_bound(Design& design, const CartesianWidths& widths, double texel_step, const Material& material);

}  // namespace bump
