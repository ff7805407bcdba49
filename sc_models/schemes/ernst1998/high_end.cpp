#include "schemes/ernst1998/high_end.h"

#include "schemes/common/cartesian_units.h"
#include "schemes/common/vertex_vectors.h"

namespace bump::ernst1998 {

namespace {

/// Outputs "L_unit", "H_unit", "N_unit": unit vectors in tangent space.
Netlist environment_unit(const ErnstParameters& p) {
  Netlist n("environment");
  const TangentSpaceVectors v = transform_pixel(n, p.widths);
  const Netlist::Label label(n, "normaliser, Lee 2007 sec. 6");
  // One normaliser for all three components, as Lee 2007 counts it, although c = 1 would spare its square.
  const Format slope = p.widths.product(p.slopes.integer_bits);
  const Format component = p.slopes.integer_bits > 0 ? slope : p.widths.product();
  const VectorWires texel{n.input("map.u", slope), n.input("map.v", slope), n.constant("c", 1, component)};
  output_vector(n, "L_unit", normalise_pixel(n, "L_unit", v.light, p.widths));
  output_vector(n, "H_unit", normalise_pixel(n, "H_unit", v.half, p.widths));
  output_vector(n, "N_unit", normalise_pixel(n, "N_unit", texel, p.widths, p.slopes.integer_bits + 1));
  return n;
}

}  // namespace

Design high_end_design(const ErnstParameters& p, const Material& material) {
  Design design;
  interpolate_vectors(design, record_vertex_vectors(design));
  design.environment = environment_unit(p);
  design.illumination = vector_illumination_unit(p.widths, material);
  design.map = slope_map(p.slopes, "u", "v", 1);
  design.map.note = "fu and fv of the inverted heights (k = -1); c = 1 is not stored";
  using Of = DeliveredDirection::Of;
  design.directions = {{Of::light, DeliveredDirection::Frame::tangent, {"L_unit.x", "L_unit.y", "L_unit.z"}},
                       {Of::half, DeliveredDirection::Frame::tangent, {"H_unit.x", "H_unit.y", "H_unit.z"}}};
  state_direction_bound(design, p.widths, p.slopes.texel().step(), material);
  return design;
}

}  // namespace bump::ernst1998
