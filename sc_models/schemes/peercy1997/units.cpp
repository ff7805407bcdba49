#include "schemes/peercy1997/units.h"

#include "schemes/common/light_tables.h"
#include "schemes/common/vectors.h"

namespace bump::peercy1997 {

namespace {

constexpr int guard_bits = 2;  // of products before they are summed: the floors of three products would bias a component by 1.5 units

/// Unit vectors leave the normalisers with one integer bit, as 1 itself occurs.
Format unit_format(const PeercyParameters& p) {
  return sfixed(p.word_bits + 1, p.word_bits - 1);
}
Format product_format(const PeercyParameters& p) {
  return sfixed(p.word_bits + 1 + guard_bits, p.word_bits - 1 + guard_bits);
}

struct Frame {
  VectorWires tangent, binormal, normal;
};

/// Eq 7: L times the matrix whose columns are T, B, N. 9 multipliers, 6 adders.
VectorWires to_tangent_space(Netlist& n, const std::string& name, const VectorWires& v, const Frame& frame, const Format& product) {
  return {dot_product(n, name + ".x", v, frame.tangent, product, product, "Eq 7"),
          dot_product(n, name + ".y", v, frame.binormal, product, product, "Eq 7"),
          dot_product(n, name + ".z", v, frame.normal, product, product, "Eq 7")};
}

void interpolate(Design& design, const std::string& name, const VectorWires& v) {
  output_vector(design.vertex, name, v);
  for (const char* component : {".x", ".y", ".z"}) design.interpolants.push_back({name + component, InterpolantKind::linear});
}

VectorWires normalise_pixel(Netlist& n, const std::string& name, const VectorWires& v, const PeercyParameters& p) {
  const int fraction = n.format(v.x).fraction;
  NormaliserFormats f;
  f.square = f.sum = ufixed(2 * fraction + 2, 2 * fraction);  // texels may be longer than 1
  f.length = ufixed(fraction + 1, fraction);
  f.quotient = unit_format(p);
  return p.divider ? normalise(n, name, v, f, f.length.step()) : normalise_by_table(n, name, v, f, p.root_table_bits, p.word_bits + 4);
}

}  // namespace

void record_vertex_program(const PeercyParameters& p, Design& design) {
  Netlist& n = design.vertex;
  const VectorWires normal = input_vector(n, "N", real()), tangent = input_vector(n, "T", real()), binormal = input_vector(n, "B", real());
  const VectorWires to_light = input_vector(n, "L", real()), to_eye = input_vector(n, "V", real());
  const VectorWires light = normalise_vertex(n, "L_unit", to_light);
  const VectorWires half = normalise_vertex(n, "H_unit", half_vector(n, "H", light, normalise_vertex(n, "V_unit", to_eye)));
  if (p.transform_per_pixel) {
    interpolate(design, "N", normal);
    interpolate(design, "T", tangent);
    interpolate(design, "B", binormal);
    interpolate(design, "L", light);
    interpolate(design, "H", half);
    return;
  }
  const Frame frame{tangent, binormal, normal};
  interpolate(design, "L_ts", to_tangent_space(n, "L_ts", light, frame, real()));
  interpolate(design, "H_ts", to_tangent_space(n, "H_ts", half, frame, real()));
}

Netlist environment_unit(const PeercyParameters& p) {
  Netlist n("environment");
  VectorWires light, half;
  if (p.transform_per_pixel) {
    Frame frame;
    frame.normal = input_vector(n, "N", p.component());
    frame.tangent = input_vector(n, "T", p.component());
    frame.binormal = input_vector(n, "B", p.component());
    const VectorWires object_light = input_vector(n, "L", p.component()), object_half = input_vector(n, "H", p.component());
    light = to_tangent_space(n, "L_ts", object_light, frame, product_format(p));
    half = to_tangent_space(n, "H_ts", object_half, frame, product_format(p));
  } else {
    light = input_vector(n, "L_ts", p.component());
    half = input_vector(n, "H_ts", p.component());
  }
  const VectorWires texel = input_vector(n, "map", n.format(light.x));  // one kind of normaliser for all three
  output_vector(n, "L_unit", normalise_pixel(n, "L_unit", light, p));
  output_vector(n, "H_unit", normalise_pixel(n, "H_unit", half, p));
  output_vector(n, "N_unit", normalise_pixel(n, "N_unit", texel, p));
  return n;
}

Netlist illumination_unit(const PeercyParameters& p, const Material& material) {
  Netlist n("illumination");
  const VectorWires light = input_vector(n, "L_unit", unit_format(p)), half = input_vector(n, "H_unit", unit_format(p));
  const VectorWires normal = input_vector(n, "N_unit", unit_format(p));
  const int fraction = p.word_bits - 1 + guard_bits;
  const Format product = sfixed(fraction + 3, fraction);
  const auto clamped_dot = [&](const std::string& name, const VectorWires& v) {
    return clamp_dot(n, name + "_lit", dot_product(n, name, normal, v, product, product, "Eq 2 of Lee 2007"), fraction);
  };
  const Wire n_l = clamped_dot("N_L", light), n_h = clamped_dot("N_H", half);
  // kd is a register that the material sets; its value is no part of the structure.
  const Wire diffuse = n.mul("diffuse", n_l, n.constant("kd", material.diffuse, light_format()), light_format());
  const Wire specular = n.table("SPEC", specular_table(clamped_dot_format(fraction), p.light_table_bits, material), n_h).front();
  n.output("intensity", n.add("intensity", diffuse, specular, intensity_format()));
  return n;
}

}  // namespace bump::peercy1997
