#include "schemes/common/cartesian_widths.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/light_tables.h"

namespace bump {

void declare_widths(Parameters& p, const std::string& id) {
  p.integer(id + ".word_bits", 12, 4, 18, "bits", "bits of a vector component, sign included");
  p.integer(id + ".light_table_bits", 10, 3, 12, "bits", "address bits of the power table");
  p.integer(id + ".light_word_bits", 16, 4, 16, "bits", "bits of a word of the light tables, one before the point");
}

CartesianWidths read_widths(const Configuration& c, const std::string& id) {
  CartesianWidths widths;
  widths.word_bits = static_cast<int>(c.integer(id + ".word_bits"));
  widths.light_table_bits = static_cast<int>(c.integer(id + ".light_table_bits"));
  widths.light_word_bits = static_cast<int>(c.integer(id + ".light_word_bits"));
  return widths;
}

double direction_floor_db(const CartesianWidths& widths, double texel_step, const Material& material) {
  const double words = 16 * std::ldexp(1.0, -widths.word_bits);
  const double root = widths.divider ? 0 : 8 * std::ldexp(1.0, -widths.root_table_bits);
  const double direction = std::sqrt(words * words + texel_step * texel_step + root * root);
  const double floor = -20 * std::log10(direction * angular_slope(material) + light_table_error(material, widths.light_table_bits));
  return std::max(3.0, light_word_floor_db(floor, widths.light_word_bits));
}

void state_direction_bound(Design& design, const CartesianWidths& widths, double texel_step, const Material& material) {
  constexpr double quarter_squared = 1.0 / 16;
  const std::string suffix = "_unit.squared";
  design.quantisation_floor_db = direction_floor_db(widths, texel_step, material);
  for (const Node& node : design.environment.nodes()) {
    const std::string& name = node.name;
    if (name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
      design.least.push_back({name, quarter_squared});
  }
}

}  // namespace bump
