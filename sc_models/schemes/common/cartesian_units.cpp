#include "schemes/common/cartesian_units.h"

#include "schemes/common/light_tables.h"

namespace bump {

VectorWires to_tangent_space(Netlist& n, const std::string& name, const VectorWires& v, const TangentFrame& frame, const Format& product) {
  return {dot_product(n, name + ".x", v, frame.tangent, product, product, "Eq 7"),
          dot_product(n, name + ".y", v, frame.binormal, product, product, "Eq 7"),
          dot_product(n, name + ".z", v, frame.normal, product, product, "Eq 7")};
}

TangentSpaceVectors transform_pixel(Netlist& n, const CartesianWidths& widths) {
  TangentFrame frame;
  frame.normal = input_vector(n, "N", widths.component());
  frame.tangent = input_vector(n, "T", widths.component());
  frame.binormal = input_vector(n, "B", widths.component());
  const VectorWires light = input_vector(n, "L", widths.component()), half = input_vector(n, "H", widths.component());
  return {to_tangent_space(n, "L_ts", light, frame, widths.product()), to_tangent_space(n, "H_ts", half, frame, widths.product())};
}

VectorWires normalise_pixel(Netlist& n, const std::string& name, const VectorWires& v, const CartesianWidths& widths, int length_bits) {
  const int fraction = n.format(v.x).fraction;
  NormaliserFormats f;
  f.square = f.sum = ufixed(2 * (fraction + length_bits), 2 * fraction);
  f.length = ufixed(fraction + length_bits, fraction);
  f.quotient = widths.unit();
  return widths.divider ? normalise(n, name, v, f, f.length.step())
                        : normalise_by_table(n, name, v, f, widths.root_table_bits, widths.word_bits + 4);
}

Netlist vector_illumination_unit(const CartesianWidths& widths, const Material& material) {
  Netlist n("illumination");
  const Netlist::Label label(n, "Eq 2 of Lee 2007");
  const VectorWires light = input_vector(n, "L_unit", widths.unit()), half = input_vector(n, "H_unit", widths.unit());
  const VectorWires normal = input_vector(n, "N_unit", widths.unit());
  const int fraction = widths.product_fraction();
  const Format product = widths.product(2);
  const auto clamped_dot = [&](const std::string& name, const VectorWires& v) {
    return clamp_dot(n, name + "_lit", dot_product(n, name, normal, v, product, product), fraction);
  };
  const Wire n_l = clamped_dot("N_L", light), n_h = clamped_dot("N_H", half);
  const Format word = light_format(widths.light_word_bits);
  // kd is a register that the material sets; its value is no part of the structure.
  const Wire diffuse = n.mul("diffuse", n_l, n.constant("kd", material.diffuse, word), word);
  const Wire specular =
      n.table("SPEC", specular_table(clamped_dot_format(fraction), widths.light_table_bits, material, widths.light_word_bits), n_h).front();
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format(widths.light_word_bits)));
  return n;
}

}  // namespace bump
