#include "schemes/ernst1998/ernst_parameters.h"

namespace bump::ernst1998 {

void declare_parameters(Parameters& p) {
  p.choice("ernst1998.variant", "high_end", {"high_end", "gouraud"},
           "per-pixel lighting as Lee 2007, Table 1, counts it, or a bump term blended onto Gouraud shading");
  declare_slopes(p, "ernst1998");
  declare_widths(p, "ernst1998");
  p.integer("ernst1998.texel_bits", 8, 3, 16, "bits", "bits of a component of the map (variant = gouraud)");
}

ErnstParameters read_parameters(const Configuration& c) {
  ErnstParameters p;
  p.high_end = c.choice("ernst1998.variant") == "high_end";
  p.widths = read_widths(c, "ernst1998");
  p.slopes = read_slopes(c, "ernst1998");
  p.texel_bits = static_cast<int>(c.integer("ernst1998.texel_bits"));
  return p;
}

}  // namespace bump::ernst1998
