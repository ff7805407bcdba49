#include "schemes/peercy1997/peercy_parameters.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump::peercy1997 {

void declare_parameters(Parameters& p) {
  p.choice("peercy1997.transform", "pixel", {"pixel", "vertex"},
           "transform of L and H into tangent space: per pixel as Lee 2007, Table 1, charges it, or at the vertices as published");
  p.choice("peercy1997.normaliser", "divider", {"divider", "table"},
           "normalisers: square root and three dividers, or a table of reciprocal roots and three multipliers");
  p.integer("peercy1997.word_bits", 12, 8, 18, "bits", "bits of a vector component, sign included");
  p.integer("peercy1997.texel_bits", 8, 4, 16, "bits", "bits of a component of the map");
  p.integer("peercy1997.light_table_bits", 10, 6, 12, "bits", "address bits of the power table");
  p.integer("peercy1997.root_table_bits", 10, 6, 14, "bits", "address bits of the reciprocal root table (normaliser = table)");
}

PeercyParameters read_parameters(const Configuration& c) {
  PeercyParameters p;
  p.transform_per_pixel = c.choice("peercy1997.transform") == "pixel";
  p.divider = c.choice("peercy1997.normaliser") == "divider";
  p.word_bits = static_cast<int>(c.integer("peercy1997.word_bits"));
  p.texel_bits = static_cast<int>(c.integer("peercy1997.texel_bits"));
  p.light_table_bits = static_cast<int>(c.integer("peercy1997.light_table_bits"));
  p.root_table_bits = static_cast<int>(c.integer("peercy1997.root_table_bits"));
  return p;
}

double quantisation_floor_db(const PeercyParameters& p, const Material& material) {
  const auto step = [](int bits) { return std::ldexp(1.0, -bits); };
  // Worst errors of a direction, in radians, by cause; the floor takes them as if every pixel had them at once.
  const double words = 16 * step(p.word_bits), texel = 2 * step(p.texel_bits);
  const double root = p.divider ? 0 : 8 * step(p.root_table_bits);
  const double direction = std::sqrt(words * words + texel * texel + root * root);
  return std::max(3.0, -20 * std::log10(direction * angular_slope(material) + light_table_error(material, p.light_table_bits)));
}

}  // namespace bump::peercy1997
