#include "schemes/ernst1998/gouraud.h"

#include <algorithm>
#include <cmath>

#include "schemes/common/cartesian_units.h"
#include "schemes/common/light_tables.h"
#include "schemes/common/vertex_vectors.h"

namespace bump::ernst1998 {

namespace {

constexpr double unbounded = 1e300;

TablePtr power_function(const Material& material) {
  Table table = *specular_table(real(), 8, material);
  table.name = "VERTEX_POWER";
  table.columns.front().format = real();
  return std::make_shared<const Table>(table);
}

/// The vertex intensity of Gouraud shading, and L in tangent space.
void record_vertex_program(Design& design, const Material& material) {
  const VertexVectors v = record_vertex_vectors(design);
  Netlist& n = design.vertex;
  const VectorWires light = to_tangent_space(n, "L_ts", v.light, {v.tangent, v.binormal, v.normal}, real());
  interpolate_vector(design, "L_ts", light);
  const Wire n_l = n.clamp("N_L_lit", light.z, 0, unbounded, real());
  const Wire n_h = n.clamp("N_H_lit", dot_product(n, "N_H", v.normal, v.half, real(), real()), 0, unbounded, real());
  const Wire diffuse = n.mul("diffuse", n_l, n.constant("kd", material.diffuse, real()), real());
  const Wire specular = n.table("POWER", power_function(material), n_h).front();
  n.output("gouraud", n.add("intensity", diffuse, specular, real()));
  design.interpolants.push_back({"gouraud", InterpolantKind::linear});
}

/// Output "relief": max(0, N'.L') - max(0, L'z).
Netlist environment_unit(const ErnstParameters& p) {
  Netlist n("environment");
  const CartesianWidths& w = p.widths;
  const int fraction = w.product_fraction();
  const VectorWires light = input_vector(n, "L_ts", w.component()), texel = input_vector(n, "map", w.product());
  const Netlist::Label label(n, "N'.L' less max(0, L'z)");
  const Wire bumped = clamp_dot(n, "N_L_lit", dot_product(n, "N_L", texel, light, w.product(2), w.product(2)), fraction);
  const Wire flat = clamp_dot(n, "flat", light.z, fraction);
  n.output("relief", n.sub("relief", bumped, flat, w.product(0)));
  return n;
}

/// Output "intensity".
Netlist illumination_unit(const ErnstParameters& p, const Material& material) {
  Netlist n("illumination");
  const Format blended = sfixed(light_format().width + 3, light_format().fraction);
  const Wire gouraud = n.input("gouraud", intensity_format()), relief = n.input("relief", p.widths.product(0));
  const Netlist::Label label(n, "plus the Gouraud intensity");
  const Wire gain = n.mul("gain", relief, n.constant("kd", material.diffuse, light_format()), blended);
  const Wire sum = n.add("blend", gouraud, gain, blended);
  n.output("intensity", n.clamp("intensity", sum, 0, intensity_format().highest(), intensity_format()));
  return n;
}

BumpEncoding normal_map(const ErnstParameters& p) {
  BumpEncoding map;
  for (const char* component : {"x", "y", "z"}) map.channels.push_back({component, p.texel(), ChannelKind::linear});
  map.encode = [](const glm::dvec3& normal, double* channels) {
    for (int i = 0; i < 3; ++i) channels[i] = normal[i];
  };
  map.filterable = true;
  map.note = "normalised when it is made, since nothing normalises per pixel";
  return map;
}

/// Worst errors of the relief, from the components of L' and texel and the floors of the sum, and of the words behind it.
double quantisation_floor_db(const ErnstParameters& p, const Material& material) {
  const auto step = [](int bits) { return std::ldexp(1.0, -bits); };
  const double relief = 6 * step(p.widths.word_bits) + 2 * step(p.texel_bits);
  return std::max(3.0, -20 * std::log10(material.diffuse * relief + 3 * light_format().step()));
}

}  // namespace

Design gouraud_design(const ErnstParameters& p, const Material& material) {
  Design design;
  record_vertex_program(design, material);
  design.environment = environment_unit(p);
  design.illumination = illumination_unit(p, material);
  design.map = normal_map(p);
  design.directions = {{DeliveredDirection::Of::light, DeliveredDirection::Frame::tangent, {"L_ts.x", "L_ts.y", "L_ts.z"}}};
  design.quantisation_floor_db = quantisation_floor_db(p, material);
  return design;
}

}  // namespace bump::ernst1998
