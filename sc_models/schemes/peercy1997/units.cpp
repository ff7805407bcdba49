#include "schemes/peercy1997/units.h"

#include "schemes/common/vertex_vectors.h"

namespace bump::peercy1997 {

namespace {

/// The program reads no frame, so that none is fetched.
void record_object_space_vectors(Design& design) {
  Netlist& n = design.vertex;
  const VectorWires to_light = input_vector(n, "L", real()), to_eye = input_vector(n, "V", real());
  const VectorWires light = normalise_vertex(n, "L_unit", to_light);
  interpolate_vector(design, "L_os", light);
  interpolate_vector(design, "H_os", normalise_vertex(n, "H_unit", half_vector(n, "H", light, normalise_vertex(n, "V_unit", to_eye))));
}

}  // namespace

void record_vertex_program(const PeercyParameters& p, Design& design) {
  if (p.map == MapSpace::object) {
    record_object_space_vectors(design);
    return;
  }
  const VertexVectors v = record_vertex_vectors(design);
  if (p.transform_per_pixel) {
    interpolate_vectors(design, v);
    return;
  }
  const TangentFrame frame{v.tangent, v.binormal, v.normal};
  interpolate_vector(design, "L_ts", to_tangent_space(design.vertex, "L_ts", v.light, frame, real()));
  interpolate_vector(design, "H_ts", to_tangent_space(design.vertex, "H_ts", v.half, frame, real()));
}

Netlist environment_unit(const PeercyParameters& p) {
  const CartesianWidths& w = p.widths;
  Netlist n("environment");
  TangentSpaceVectors v;
  if (p.map == MapSpace::object) {
    v.light = input_vector(n, "L_os", w.component());
    v.half = input_vector(n, "H_os", w.component());
  } else if (p.transform_per_pixel) {
    v = transform_pixel(n, w);
  } else {
    v.light = input_vector(n, "L_ts", w.component());
    v.half = input_vector(n, "H_ts", w.component());
  }
  const Netlist::Label label(n, "Fig. 3, normaliser");
  const VectorWires texel = input_vector(n, "map", n.format(v.light.x));  // one kind of normaliser for all three
  output_vector(n, "L_unit", normalise_pixel(n, "L_unit", v.light, w));
  output_vector(n, "H_unit", normalise_pixel(n, "H_unit", v.half, w));
  output_vector(n, "N_unit", normalise_pixel(n, "N_unit", texel, w));
  return n;
}

}  // namespace bump::peercy1997
